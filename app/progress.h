#pragma once

#include <chrono>
#include <cstdio>
#include <optional>
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
  /// What is being done, and about how long it takes: on a terminal until the next line; elsewhere
  /// as a line, if it takes long.
  void phase(const std::string& what, std::optional<double> seconds = std::nullopt);
  void step(const fem::StepReport& report);
  void level(const fem::LevelRecord& record);

  /// Everything that was shown as lines so far.
  [[nodiscard]] const std::string& log() const { return log_; }

 private:
  void write(const std::string& text, const std::string& prefix, std::FILE* stream);
  void clear_status();
  void show_status(const std::string& text);
  [[nodiscard]] double elapsed() const;

  bool is_speaking_;
  bool is_terminal_;
  base::OutputUnit stress_;
  unsigned int levels_ = 0;
  std::optional<double> cost_;  ///< of the last mesh, per unknown [s]
  double expected_end_ = 0.;    ///< of the mesh that is solved [s]; 0: unknown
  double last_end_ = 0.;        ///< of the last mesh [s]
  std::string last_level_;      ///< peak pressure and estimated error so far
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  bool has_status_ = false;
  std::string log_;
};

}  // namespace geneva::app
