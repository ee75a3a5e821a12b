#include "app/ticker.h"

#include <signal.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <string>
#include <utility>

namespace geneva::app {

namespace {

/// Starts a thread that takes no signals: they are the other threads'.
std::thread quiet_thread(const std::function<void()>& task) {
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  std::thread thread(task);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return thread;
}

/// As much of a line as fits into the terminal's width: one that is broken could not be taken away.
std::string fitted(const std::string& text) {
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return text;
  return text.substr(0, size.ws_col - 1U);
}

}  // namespace

Ticker::~Ticker() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_ended_ = true;
  }
  changed_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void Ticker::show(Text text) {
  const std::lock_guard<std::mutex> lock(mutex_);
  text_ = std::move(text);
  start_ = std::chrono::steady_clock::now();
  draw();
  if (!thread_.joinable()) thread_ = quiet_thread([this] { run(); });
}

void Ticker::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!text_) return;
  text_ = nullptr;
  std::fputs("\r\033[K", stdout);
  std::fflush(stdout);
}

void Ticker::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!changed_.wait_for(lock, std::chrono::seconds(1), [this] { return is_ended_; }))
    if (text_) draw();
}

void Ticker::draw() {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  std::fputs(("\r\033[K" + fitted(text_(elapsed.count()))).c_str(), stdout);
  std::fflush(stdout);
}

}  // namespace geneva::app
