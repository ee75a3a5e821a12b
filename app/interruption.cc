#include "app/interruption.h"

#include <fmt/format.h>
#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <ctime>
#include <exception>
#include <string>
#include <thread>
#include <utility>

#include "app/exit_code.h"
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

int next_interruption(const OtherRanks& others) {
  const sigset_t signals = interruptions();
  const timespec patience{0, 100'000'000};
  while (true) {
    const int signal = sigtimedwait(&signals, nullptr, &patience);
    if (signal > 0) return signal;
    if (others.look) others.look();
  }
}

/// Never put away: the other thread may be reading it.
std::atomic<const std::string*> advice_now{nullptr};

void wait_for_interruption(const OtherRanks& others) {
  const int signal = next_interruption(others);
  const sigset_t signals = interruptions();
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);  // a second one ends the process
  base::undo_all();
  if (others.speaks()) {
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

[[noreturn]] void end_at_once() {
  if (base::failed_allocations() > 0) end_for_memory();
  end_with(bug_report("an exception that cannot be caught", *task.load()), internal_error);
}

}  // namespace

void end_for_memory() { end_with(fmt::format("memory ran out ({})", *task.load()), not_converged); }

void watch_for_interruption(OtherRanks others) {
  const sigset_t signals = interruptions();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  // A reader that has gone, or a file that may not grow, shows in what the write returns. Blocked,
  // not ignored: libraries set their own handlers.
  sigset_t of_writing;
  sigemptyset(&of_writing);
  for (const int signal : {SIGPIPE, SIGXFSZ}) sigaddset(&of_writing, signal);
  pthread_sigmask(SIG_BLOCK, &of_writing, nullptr);
  // MPI changes the environment while it starts: it must not be read on another thread.
  std::thread(wait_for_interruption, std::move(others)).detach();
}

void say_if_interrupted(const std::string& advice) { advice_now = new std::string(advice); }

void watch_for_termination(const std::string& about) {
  task = new std::string(about);
  base::count_failed_allocations();
  std::set_terminate(end_at_once);
}

}  // namespace geneva::app
