#pragma once

#include <memory>

namespace geneva {

/// MPI and the libraries of the solver, from here to its end: one in a process, made at the start
/// of main(), before other threads are. Where MPI has been started already it stays so in the end.
class Session {
 public:
  Session(int& argc, char**& argv);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

 private:
  struct Libraries;
  std::unique_ptr<Libraries> libraries_;  ///< none if MPI was not started here
};

}  // namespace geneva
