#include "mesher/gmsh_session.h"

#include <gmsh.h>

#include <exception>
#include <new>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace geneva::mesher {

namespace {

constexpr std::string_view error_prefix = "Error: ";

/// Of std::bad_alloc and its like the own text is a name of C++, which tells a user nothing.
constexpr const char* impossible_length =
    "memory ran out ('Maximum memory'), or a list of impossible length is asked for";

/// Runs some of Gmsh's functions.
/// @return why they did not come to their end; nothing if they did
std::optional<std::string> failure_of(const std::function<void()>& action) {
  try {
    action();
    return std::nullopt;
  } catch (const std::string& message) {  // what Gmsh itself throws
    return message;
  } catch (const std::bad_alloc&) {
    return impossible_length;
  } catch (const std::length_error&) {
    return impossible_length;
  } catch (const std::out_of_range&) {
    return "a number is used that stands for nothing (for a node, a curve, an entry of a list)";
  } catch (const std::exception& exception) {
    return exception.what();
  } catch (...) {
    return "Gmsh met an error that it has no words for";
  }
}

}  // namespace

GmshSession::GmshSession() {
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::option::setNumber("General.Verbosity", 2);
  // errors are collected instead of thrown: an exception through Gmsh's parser leaves it unusable
  gmsh::option::setNumber("General.AbortOnError", 0);
  gmsh::option::setNumber("General.NumThreads", 1);
  gmsh::logger::start();
}

GmshSession::~GmshSession() {
  gmsh::model::mesh::removeSizeCallback();  // it would outlive what it refers to
  gmsh::logger::stop();
  gmsh::finalize();
}

std::vector<std::string> GmshSession::errors_of(const std::function<void()>& action) {
  const std::optional<std::string> failure = failure_of(action);
  std::vector<std::string> errors;
  std::vector<std::string> messages;
  gmsh::logger::get(messages);
  for (std::size_t i = messages_seen_; i < messages.size(); ++i)
    if (messages[i].rfind(error_prefix, 0) == 0)
      errors.push_back(messages[i].substr(error_prefix.size()));
  messages_seen_ = messages.size();
  if (failure) errors.push_back(*failure);
  return errors;
}

void set_quadrilateral_options() {
  gmsh::option::setNumber("Mesh.Algorithm", 6);
  gmsh::option::setNumber("Mesh.RecombineAll", 1);
  gmsh::option::setNumber("Mesh.RecombinationAlgorithm", 1);
  gmsh::option::setNumber("Mesh.RandomSeed", 1);
}

}  // namespace geneva::mesher
