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

void ProgressDisplay::clear_status() {
  if (has_status_) std::fputs("\r\033[K", stdout);
  has_status_ = false;
}

void ProgressDisplay::write(const std::string& text, const std::string& prefix,
                            std::FILE* const stream) {
  if (!is_speaking_) return;
  clear_status();
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

void ProgressDisplay::show_status(const std::string& text) {
  std::fputs(("\r\033[K" + text).c_str(), stdout);
  std::fflush(stdout);
  has_status_ = true;
}

void ProgressDisplay::phase(const std::string& what, const std::optional<double> seconds) {
  constexpr double worth_a_line = 4.;
  if (!is_speaking_) return;
  const std::string text =
      seconds && *seconds >= 1. ? fmt::format("{}, about {:.0f} s", what, *seconds) : what;
  if (is_terminal_)
    show_status(text);
  else if (seconds && *seconds >= worth_a_line)
    line(text);
}

void ProgressDisplay::step(const fem::StepReport& report) {
  if (!is_speaking_) return;
  if (report.step == 0) {
    const auto expected = cost_ ? std::optional(*cost_ * report.dofs) : std::nullopt;
    expected_end_ = expected ? elapsed() + *expected : 0.;
    phase(fmt::format("solving a mesh of {} unknowns", report.dofs), expected);
    return;
  }
  if (!is_terminal_) return;
  const double left = expected_end_ - elapsed();
  show_status(
      fmt::format("level {:>2}  {:>8} unknowns  active-set step {}  CG {}  {}{}", report.level,
                  report.dofs, report.step, report.linear_iterations, last_level_,
                  left >= 1. ? fmt::format("  about {:.0f} s left of this mesh", left) : ""));
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
  cost_ = (elapsed() - last_end_) / record.dofs;
  last_end_ = elapsed();
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
