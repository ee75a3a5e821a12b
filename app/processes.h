#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace geneva::app {

/// Programs that run beside this one, and end with it.
class Processes {
 public:
  Processes() = default;
  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;
  /// Ends those that still run.
  ~Processes();

  /// Starts a program whose output goes into a file.
  /// @param done called by wait() with its exit code; 128 and the signal's number if one ended it
  /// @throws base::InputError if it cannot be started
  void start(const std::vector<std::string>& command, const std::filesystem::path& output,
             std::function<void(int)> done);
  /// Waits for the next of them to end, and calls its `done`.
  void wait();

  [[nodiscard]] std::size_t size() const { return running_.size(); }

 private:
  std::map<int, std::function<void(int)>> running_;  ///< by process id
};

}  // namespace geneva::app
