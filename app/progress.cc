#include "app/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "app/highlight.h"
#include "base/printable.h"

namespace geneva::app {

ProgressDisplay::ProgressDisplay(const bool is_speaking, const base::UnitSystem units)
    : is_speaking_(is_speaking),
      is_terminal_(is_terminal(stdout)),
      stress_(base::output_unit(units, base::Dimension::stress)) {}

namespace {

/// What is done, and the time that is left of what it is expected to take.
/// @param expected [s]; 0: unknown
std::string with_time(const std::string& what, const double expected, const double elapsed) {
  constexpr double worth_telling = 2.;
  const double left = expected - elapsed;
  if (left >= 0.5) return fmt::format("{}, about {:.0f} s left", what, std::max(1., left));
  if (elapsed >= worth_telling) return fmt::format("{}, {:.0f} s so far", what, elapsed);
  return what;
}

const char* words_of(const fem::Work work) {
  switch (work) {
    case fem::Work::stresses:
      return "finding the stresses and errors";
    case fem::Work::figures:
      return "working out the figures of this mesh";
    case fem::Work::refinement:
      return "refining the mesh";
    case fem::Work::results:
      return "working out the results";
    case fem::Work::writing:
      break;
  }
  return "writing the results";
}

}  // namespace

void ProgressDisplay::write(const std::string& text, const std::string& prefix,
                            std::FILE* const stream) {
  if (!is_speaking_) return;
  status_.clear();
  std::fflush(stdout);
  const std::string shown = base::without_controls(text);  // titles and names are the user's
  std::fputs((for_stream(prefix + shown, stream) + "\n").c_str(), stream);
  std::fflush(stream);
  log_ += shown + "\n";
}

void ProgressDisplay::line(const std::string& text) { write(text, "", stdout); }

void ProgressDisplay::warning(const std::string& text) { write(text, "geneva: ", stderr); }

double ProgressDisplay::elapsed() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void ProgressDisplay::phase(const std::string& what, const std::optional<double> seconds) {
  constexpr double worth_a_line = 4.;
  if (!is_speaking_) return;
  if (is_terminal_)
    status_.show([what, expected = seconds.value_or(0.)](const double elapsed) {
      return with_time(what, expected, elapsed);
    });
  else if (seconds && *seconds >= worth_a_line)
    line(fmt::format("{}, about {:.0f} s", what, *seconds));
}

void ProgressDisplay::end_work() {
  if (!work_) return;
  cost_of_last_work_ = (elapsed() - work_start_) / work_->dofs;
  cost_of_work_[work_->work] = *cost_of_last_work_;
  work_.reset();
}

void ProgressDisplay::work(const fem::WorkReport& report, const double times_the_last) {
  end_work();
  work_ = report;
  work_start_ = elapsed();
  std::optional<double> cost;
  if (cost_of_work_.count(report.work) > 0)
    cost = cost_of_work_.at(report.work);
  else if (cost_of_last_work_)
    cost = times_the_last * *cost_of_last_work_;
  phase(words_of(report.work), cost ? std::optional(*cost * report.dofs) : std::nullopt);
}

Progress ProgressDisplay::watch() {
  Progress watch;
  watch.step = [this](const fem::StepReport& report) { step(report); };
  watch.mesh = [this](const fem::LevelRecord& record) { level(record); };
  watch.work = [this](const fem::WorkReport& report) { work(report); };
  return watch;
}

void ProgressDisplay::step(const fem::StepReport& report) {
  if (!is_speaking_) return;
  if (report.step == 0) {
    end_work();
    mesh_start_ = elapsed();
    const auto expected = cost_ ? std::optional(*cost_ * report.dofs) : std::nullopt;
    expected_end_ = expected ? elapsed() + *expected : 0.;
    phase(fmt::format("solving a mesh of {} unknowns", report.dofs), expected);
    return;
  }
  if (!is_terminal_) return;
  const std::string text =
      fmt::format("level {:>2}  {:>8} unknowns  active-set step {}  CG {}  {}", report.level,
                  report.dofs, report.step, report.linear_iterations, last_level_);
  status_.show([text, left = expected_end_ - elapsed()](const double since) {
    return left - since < 1. ? text : fmt::format("{}  about {:.0f} s left", text, left - since);
  });
}

namespace {

/// The figure that the meshes are refined for.
struct Refined {
  const char* name;
  double value;  ///< [Pa]
};

/// Without contact there is no pressure.
Refined refined_of(const fem::LevelRecord& record) {
  if (record.active_nodes > 0) return {"peak pressure", record.peak_pressure};
  double maximum = 0.;
  for (const fem::StrengthRecord& body : record.strength)
    maximum = std::max(maximum, body.von_mises.value);
  return {"von Mises stress", maximum};
}

}  // namespace

void ProgressDisplay::level(const fem::LevelRecord& record) {
  const Refined refined = refined_of(record);
  end_work();
  cost_ = (elapsed() - mesh_start_) / record.dofs;
  if (levels_ == 0)
    line(fmt::format("{:>5}{:>10}{:>8}{:>6}{:>8}{:>25}{:>12}{:>9}", "level", "unknowns", "active",
                     "steps", "CG", fmt::format("{} [{}]", refined.name, stress_.name),
                     "est. error", "time"));
  const unsigned int iterations =
      std::accumulate(record.linear_iterations.begin(), record.linear_iterations.end(), 0U);
  const std::string error = record.error_estimate < 1.
                                ? fmt::format("{:.2g} %", 100. * record.error_estimate)
                                : std::string("-");
  line(fmt::format("{:>5}{:>10}{:>8}{:>6}{:>8}{:>25.6g}{:>12}{:>7.2f} s", levels_, record.dofs,
                   record.active_nodes, record.linear_iterations.size(), iterations,
                   refined.value * stress_.factor, error, record.seconds));
  last_level_ = fmt::format("{} {:.5g} {}, est. error {}", refined.name,
                            refined.value * stress_.factor, stress_.name, error);
  if (record.cycled)
    line(
        "note: the active set came back to an earlier one on this mesh; its nodes then could only "
        "close");
  ++levels_;
}

}  // namespace geneva::app
