#include "app/early_mesher.h"

#include "app/launch.h"

namespace geneva::app {

namespace {

bool needs_mesher(const Request& request) {
  return request.command == Request::Command::run || request.command == Request::Command::crown;
}

}  // namespace

std::optional<mesh::Mesher> early_mesher(const Request& request) {
  if (!needs_mesher(request) || !is_launched_as_first_rank()) return std::nullopt;
  return std::optional<mesh::Mesher>(std::in_place, mesh::mesher_beside_this_program());
}

void start_if_needed(const Request& request, std::optional<mesh::Mesher>& mesher) {
  if (needs_mesher(request) && !mesher) mesher.emplace(mesh::mesher_beside_this_program());
}

}  // namespace geneva::app
