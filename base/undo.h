#pragma once

#include <functional>
#include <list>
#include <mutex>

namespace geneva::base {

/// What has to be put away if the process is interrupted: a file half written, a lock.
///
/// The process has one list of them, since signals go to the process; see undo_all().
class Undo {
 public:
  /// @param action must not throw; runs on another thread
  explicit Undo(std::function<void()> action);
  /// Takes it from the list; the action does not run.
  ~Undo();
  Undo(const Undo&) = delete;
  Undo& operator=(const Undo&) = delete;

 private:
  std::list<std::function<void()>>::iterator place_;
};

/// While one is held, undo_all() waits: for what must not be left half done.
[[nodiscard]] std::unique_lock<std::recursive_mutex> not_to_be_interrupted();

/// Runs the actions, the newest first, and keeps the process from doing anything that an Undo
/// guards: to be called when it is about to end.
void undo_all();

}  // namespace geneva::base
