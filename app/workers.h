#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace geneva::app {

/// Word on geneva-solver's command line that makes it a worker.
constexpr const char* worker_word = "--worker";

/// How a worker's reply ends.
constexpr const char* worker_goes_on = "next";
constexpr const char* worker_is_used_up = "end";

/// A case that a worker solves as `geneva run` does.
struct WorkerTask {
  std::filesystem::path case_directory;
  std::filesystem::path log;      ///< what the run prints
  std::function<void(int)> done;  ///< called by Workers::wait() with the exit code; 128 and the
                                  ///< signal's number if one ended the worker
};

/// Solvers that run beside this process, each one case after the other, so that their start is
/// paid once; they end with this object or its process.
class Workers {
 public:
  Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  ~Workers();

  /// Gives a case to an idle worker, a new one if there is none.
  /// @throws base::InputError if none can be started
  void start(WorkerTask task);
  /// Waits for the next case to end, and calls its `done`.
  void wait();

  [[nodiscard]] std::size_t busy() const;

 private:
  struct Worker {
    pid_t id;
    int requests;  ///< file descriptors
    int replies;
    WorkerTask task;  ///< without `done` where it is idle
  };

  Worker& idle_worker();
  /// Takes a worker off the list, and waits for its end.
  /// @return its exit code
  int dismiss(std::size_t place);

  std::vector<Worker> workers_;
};

}  // namespace geneva::app
