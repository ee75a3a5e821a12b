#include "mesher/gmsh_session.h"

#include <gmsh.h>

#include <exception>
#include <string_view>

namespace geneva::mesher {

namespace {

constexpr std::string_view error_prefix = "Error: ";

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
  std::vector<std::string> thrown;
  try {
    action();
  } catch (const std::exception& exception) {
    thrown.emplace_back(exception.what());
  } catch (const std::string& message) {  // what Gmsh itself throws
    thrown.push_back(message);
  }
  std::vector<std::string> errors;
  std::vector<std::string> messages;
  gmsh::logger::get(messages);
  for (std::size_t i = messages_seen_; i < messages.size(); ++i)
    if (messages[i].rfind(error_prefix, 0) == 0)
      errors.push_back(messages[i].substr(error_prefix.size()));
  messages_seen_ = messages.size();
  errors.insert(errors.end(), thrown.begin(), thrown.end());
  return errors;
}

void set_quadrilateral_options() {
  gmsh::option::setNumber("Mesh.Algorithm", 6);
  gmsh::option::setNumber("Mesh.RecombineAll", 1);
  gmsh::option::setNumber("Mesh.RecombinationAlgorithm", 1);
  gmsh::option::setNumber("Mesh.RandomSeed", 1);
}

}  // namespace geneva::mesher
