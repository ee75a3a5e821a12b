#include "app/early_mesher.h"

#include <cstdlib>
#include <string>

namespace geneva::app {

namespace {

bool is_launched_as_first_rank() {
  for (const char* const name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"})
    if (const char* const rank = std::getenv(name)) return std::string(rank) == "0";
  return true;
}

}  // namespace

bool needs_mesher(const Request& request) {
  return request.command == Request::Command::run || request.command == Request::Command::crown;
}

std::optional<mesh::Mesher> early_mesher(const Request& request) {
  if (!needs_mesher(request) || !is_launched_as_first_rank()) return std::nullopt;
  return std::optional<mesh::Mesher>(std::in_place, mesh::mesher_beside_this_program());
}

}  // namespace geneva::app
