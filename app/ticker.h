#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace geneva::app {

/// The last line of a terminal, which is written anew every second, so that a long computation
/// shows that it goes on.
class Ticker {
 public:
  /// @param elapsed since the line is shown [s]
  using Text = std::function<std::string(double elapsed)>;

  Ticker() = default;
  ~Ticker();
  Ticker(const Ticker&) = delete;
  Ticker& operator=(const Ticker&) = delete;

  /// Shows a line in the place of the one before.
  void show(Text text);
  /// Takes the line away: then others may write.
  void clear();

 private:
  void run();
  void draw();

  std::mutex mutex_;  ///< of all below but the thread
  std::condition_variable changed_;
  Text text_;  ///< empty: no line
  std::chrono::steady_clock::time_point start_;
  bool is_ended_ = false;
  std::thread thread_;
};

}  // namespace geneva::app
