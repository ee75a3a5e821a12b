#include "app/interruption.h"

#include <fmt/format.h>
#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <ctime>
#include <exception>
#include <string>
#include <thread>

#include "app/ending.h"
#include "app/exit_code.h"
#include "app/launch.h"
#include "base/allocation.h"
#include "base/undo.h"

namespace geneva::app {

namespace {

sigset_t interruptions() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&signals, signal);
  return signals;
}

const char* name_of(const int signal) {
  return signal == SIGINT ? "SIGINT" : signal == SIGTERM ? "SIGTERM" : "SIGHUP";
}

/// What another rank's failure asks of this one, once.
void look_at_other_ranks(const bool is_first) {
  if (!is_first || failure_on_this_machine() != FailureStage::alone) return;
  base::undo_all();
  note_that_all_is_undone();
}

/// Sees a rank that waits for ever for the others, which wait for it: an allocation has failed on
/// it within a collective call of a library, whose guards wait for all ranks on the way out of it.
class DeadlockWatch {
 public:
  void look() {
    const auto now = std::chrono::steady_clock::now();
    if (!base::has_unsettled_allocation())
      settled_at_ = now;
    else if (now - settled_at_ > patience && begin_to_end_alone())
      end_for_memory();
  }

 private:
  /// A failed allocation is settled by the end of the mesh's solution at the latest.
  static constexpr std::chrono::seconds patience{30};

  [[noreturn]] static void end_for_memory();

  std::chrono::steady_clock::time_point settled_at_ = std::chrono::steady_clock::now();
};

int next_interruption(const bool is_first) {
  const sigset_t signals = interruptions();
  const timespec patience{0, 100'000'000};
  DeadlockWatch deadlocks;
  while (true) {
    const int signal = sigtimedwait(&signals, nullptr, &patience);
    if (signal > 0) return signal;
    look_at_other_ranks(is_first);
    deadlocks.look();
  }
}

/// Never put away: the other thread may be reading it.
std::atomic<const std::string*> advice_now{nullptr};

void wait_for_interruption(const bool is_first) {
  const int signal = next_interruption(is_first);
  const sigset_t signals = interruptions();
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);  // a second one ends the process
  base::undo_all();
  if (is_first && failure_on_this_machine() == FailureStage::none) {
    const std::string* const advice = advice_now;
    const std::string text = fmt::format(
        "\ngeneva: interrupted ({}); nothing was left half written{}{}\n", name_of(signal),
        advice == nullptr ? "" : "; ", advice == nullptr ? "" : *advice);
    (void)!::write(STDERR_FILENO, text.data(), text.size());
  }
  _exit(128 + signal);
}

/// For watch_for_termination(): the process has one handler of each kind.
std::atomic<const std::string*> task = nullptr;

[[noreturn]] void end_with(const std::string& why, const int code) {
  base::undo_all();
  const std::string text = "geneva: " + why + "\n";
  (void)!::write(STDERR_FILENO, text.data(), text.size());
  _exit(code);
}

std::string memory_ran_out() { return fmt::format("memory ran out ({})", *task.load()); }

void DeadlockWatch::end_for_memory() { end_with(memory_ran_out(), not_converged); }

[[noreturn]] void end_at_once() {
  if (base::failed_allocations() > 0) end_with(memory_ran_out(), not_converged);
  end_with(bug_report("an exception that cannot be caught", *task.load()), internal_error);
}

}  // namespace

void watch_for_interruption() {
  const sigset_t signals = interruptions();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  // A reader that has gone, or a file that may not grow, shows in what the write returns. Blocked,
  // not ignored: libraries set their own handlers.
  sigset_t of_writing;
  sigemptyset(&of_writing);
  for (const int signal : {SIGPIPE, SIGXFSZ}) sigaddset(&of_writing, signal);
  pthread_sigmask(SIG_BLOCK, &of_writing, nullptr);
  // MPI changes the environment while it starts: it must not be read on another thread.
  std::thread(wait_for_interruption, is_launched_as_first_rank()).detach();
}

void say_if_interrupted(const std::string& advice) { advice_now = new std::string(advice); }

void watch_for_termination(const std::string& about) {
  task = new std::string(about);
  base::count_failed_allocations();
  std::set_terminate(end_at_once);
}

}  // namespace geneva::app
