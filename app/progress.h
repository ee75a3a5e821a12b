#pragma once

#include <chrono>
#include <cstdio>
#include <string>

#include "base/units.h"
#include "fem/adaptivity/level_record.h"
#include "fem/step_report.h"

namespace geneva::app {

/// Shows how far a run is: a line that is rewritten on a terminal, plain lines elsewhere; every
/// finished level also goes to the log.
class ProgressDisplay {
 public:
  /// @param is_speaking whether this rank writes at all
  ProgressDisplay(bool is_speaking, base::UnitSystem units);

  void line(const std::string& text);
  /// Goes to the standard error instead.
  void warning(const std::string& text);
  void step(const fem::StepReport& report);
  void level(const fem::LevelRecord& record);

  /// Everything that was shown as lines so far.
  [[nodiscard]] const std::string& log() const { return log_; }

 private:
  void write(const std::string& text, const std::string& prefix, std::FILE* stream);
  void clear_status();

  bool is_speaking_;
  bool is_terminal_;
  base::OutputUnit stress_;
  unsigned int levels_ = 0;
  std::string last_level_;  ///< peak pressure and estimated error so far
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  bool has_status_ = false;
  std::string log_;
};

}  // namespace geneva::app
