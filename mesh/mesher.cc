#include "mesh/mesher.h"

#include <fmt/format.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <regex>
#include <system_error>
#include <utility>

#include "base/errors.h"
#include "base/installed_program.h"
#include "base/printable.h"

namespace geneva::mesh {

namespace {

using nlohmann::json;

[[noreturn]] void too_long(const MesherLimits& limits) {
  throw base::LimitReached(fmt::format(
      "Gmsh took more than {:.3g} s for the coarse mesh: draw what is simpler or coarser{}",
      limits.seconds, limits.seconds < longest_meshing ? ", or raise 'Maximum time'" : ""));
}

[[noreturn]] void too_much(const MesherLimits& limits) {
  throw base::LimitReached(
      fmt::format("Gmsh took more than {:.3g} GB for the coarse mesh: draw what is simpler or "
                  "coarser, or raise "
                  "'Maximum memory'",
                  1e-9 * limits.memory));
}

std::string name_of(const int signal) {
  switch (signal) {
    case SIGSEGV:
    case SIGBUS:
      return "it read or wrote where it has no memory";
    case SIGABRT:
      return "it found an error in itself";
    case SIGFPE:
      return "it calculated what cannot be";
    default:
      return fmt::format("signal {}", signal);
  }
}

/// The last that it printed, as far as it says something to a user: of a check of C that failed the
/// place, of an exception of C++ nothing.
std::string in_words(const std::string& message) {
  static const std::regex check("([^/ :]+:[0-9]+): .*Assertion .* failed");
  if (std::smatch found; std::regex_search(message, found, check))
    return fmt::format("a check at {} failed", found[1].str());
  for (const char* const word : {"what():", "terminate called"})
    if (message.find(word) != message.npos) return "";
  return message;
}

/// How it ended without an answer.
/// @throws base::LimitReached if it says that it has no memory left
MesherAnswer without_answer(const ProcessEnd& end, const MesherLimits& limits) {
  for (const char* const word : {"bad_alloc", "ut of memory"})
    if (end.last_message.find(word) != std::string::npos) too_much(limits);
  std::string text = end.signal == 0
                         ? "Gmsh ended without a mesh"
                         : fmt::format("Gmsh or its CAD kernel crashed ({})", name_of(end.signal));
  const std::string message = in_words(end.last_message);
  if (!message.empty()) text += ", its last message: " + message;
  return {json(), {text}};
}

MesherAnswer answer_of(json said, const ProcessEnd& end, const MesherLimits& limits) {
  if (!said.is_object()) return without_answer(end, limits);
  if (said.contains("out_of_memory")) too_much(limits);
  MesherAnswer answer;
  if (const auto errors = said.find("errors"); errors != said.end() && errors->is_array())
    for (const json& error : *errors)
      if (error.is_string()) answer.errors.push_back(base::printable(error.get<std::string>()));
  if (const auto mesh = said.find("mesh"); mesh != said.end()) answer.mesh = std::move(*mesh);
  if (answer.mesh.is_null() && answer.errors.empty()) return without_answer(end, limits);
  return answer;
}

}  // namespace

std::filesystem::path installed_mesher() {
  std::filesystem::path program = base::installed_program("geneva-mesher");
  if (std::error_code ignored; std::filesystem::exists(program, ignored)) return program;
  std::string places;
  for (const auto& place : base::places_of_installed_program("geneva-mesher"))
    places += (places.empty() ? "" : ", ") + place.string();
  throw base::InputError(
      fmt::format("the mesher, without which nothing can be solved, is missing: there is no {}; "
                  "build or install geneva as a whole",
                  places));
}

Mesher::Mesher(const std::filesystem::path& program)
    : server_(std::make_unique<MesherServer>(program)) {}

MesherAnswer Mesher::answer_to(const json& task, const MesherLimits& limits) {
  const json request{{"task", task},
                     {"limits", {{"memory", limits.memory}, {"seconds", limits.seconds}}}};
  auto process = server_->process(limits.seconds);
  if (!process) too_long(limits);
  const ProcessEnd end =
      process->ask(request.dump(), limits.seconds, static_cast<std::size_t>(limits.memory));
  if (end.took_too_long || end.signal == SIGXCPU) too_long(limits);
  json said = json::parse(end.output, nullptr, false);
  if (said.is_object()) {
    was_enclosed_ = said.value("is_enclosed", json()) == json(true);
    if (const json version = said.value("gmsh_version", json()); version.is_string())
      gmsh_version_ = version.get<std::string>();
  }
  return answer_of(std::move(said), end, limits);
}

}  // namespace geneva::mesh
