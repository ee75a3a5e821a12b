#pragma once

#include <chrono>
#include <cstdio>
#include <map>
#include <optional>
#include <string>

#include "api/analysis.h"
#include "app/ticker.h"
#include "base/units.h"
#include "fem/adaptivity/level_record.h"
#include "fem/step_report.h"
#include "fem/work_report.h"

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
  /// What is being done, and about how long it takes: on a terminal until the next line, with the
  /// time that is left, or that has gone by where that is not known; elsewhere as a line, if it
  /// takes long.
  void phase(const std::string& what, std::optional<double> seconds = std::nullopt);
  void step(const fem::StepReport& report);
  /// What an analysis tells, all of it shown here.
  [[nodiscard]] Progress watch();

  /// Takes about as long per unknown as last time; the first time as what was done just before,
  /// times a factor.
  void work(const fem::WorkReport& report, double times_the_last = 1.);
  void level(const fem::LevelRecord& record);

  /// Everything that was shown as lines so far.
  [[nodiscard]] const std::string& log() const { return log_; }

 private:
  void write(const std::string& text, const std::string& prefix, std::FILE* stream);
  [[nodiscard]] double elapsed() const;
  void end_work();

  bool is_speaking_;
  bool is_terminal_;
  base::OutputUnit stress_;
  unsigned int levels_ = 0;
  std::optional<double> cost_;  ///< of the last mesh, per unknown [s]
  double expected_end_ = 0.;    ///< of the mesh that is solved [s]; 0: unknown
  double mesh_start_ = 0.;      ///< of the mesh that is solved [s]
  std::string last_level_;      ///< peak pressure and estimated error so far
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::map<fem::Work, double> cost_of_work_;  ///< last time, per unknown [s]
  std::optional<double> cost_of_last_work_;   ///< per unknown [s]
  std::optional<fem::WorkReport> work_;       ///< what is being done beside solving
  double work_start_ = 0.;
  Ticker status_;
  std::string log_;
};

}  // namespace geneva::app
