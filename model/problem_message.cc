#include "model/problem_message.h"

#include <fmt/format.h>

namespace geneva::model {

namespace {

const char* parameter_of(const fem::ProblemPart part) {
  switch (part) {
    case fem::ProblemPart::bodies:
      return "Bodies";
    case fem::ProblemPart::supports:
      return "Supports";
    case fem::ProblemPart::loads:
      return "Loads";
    default:
      return "Contact pairs";
  }
}

}  // namespace

std::string message_of(const fem::ProblemError& error) {
  return fmt::format("'{}': {}", parameter_of(error.part), error.what());
}

}  // namespace geneva::model
