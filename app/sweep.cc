#include "app/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <system_error>
#include <thread>

#include "api/sweep.h"
#include "api/version.h"
#include "app/commands.h"
#include "app/exit_code.h"
#include "app/highlight.h"
#include "app/launch.h"
#include "app/pace.h"
#include "app/ticker.h"
#include "app/workers.h"
#include "base/directory_lock.h"
#include "base/directory_replacement.h"
#include "base/errors.h"
#include "base/output_file.h"

namespace geneva::app {

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Last line of a run's output that says what was wrong.
std::string complaint_in(const fs::path& log) {
  std::ifstream stream(log);
  const std::string mark = "geneva: ";
  std::string complaint;
  for (std::string line; std::getline(stream, line);)
    if (line.rfind(mark, 0) == 0) complaint = line.substr(mark.size());
  return complaint;
}

/// Files that a point needs beside its case.prm, within the case's directory: those that the case
/// names, and of a geometry what lies beside its file, which may include it.
std::vector<fs::path> companions(const Case& given) {
  std::vector<fs::path> files;
  for (auto input = given.inputs.begin() + 1; input != given.inputs.end(); ++input)
    files.push_back(input->lexically_relative(given.directory));
  if (!given.geometry) return files;
  for (const fs::directory_entry& entry : fs::directory_iterator(given.directory)) {
    const fs::path name = entry.path().filename();
    if (entry.is_regular_file() && name != "case.prm" &&
        std::find(files.begin(), files.end(), name) == files.end())
      files.push_back(name);
  }
  return files;
}

/// The points of a sweep whose command is 'run', each a case in a directory of its own.
class Runs {
 public:
  Runs(const fs::path& directory, const unsigned int jobs, post::SweepReport& report)
      : directory_(directory), jobs_(jobs), report_(report) {}

  void make(std::vector<SweepCase>& cases) {
    move_solved(cases);
    remove_stale();
    to_solve_ = static_cast<std::size_t>(
        std::count_if(cases.begin(), cases.end(),
                      [](const SweepCase& point) { return point.given.has_value(); }));
    for (std::size_t i = 0; i < cases.size(); ++i) {
      if (!cases[i].given) continue;
      while (workers_.busy() >= jobs_) wait();
      if (is_solved(place(i), *cases[i].given) && read_figures(i)) {
        ++kept_;
        take(i, stored_code(i), ", kept from the last sweep");
      } else {
        try_to_start(i, *cases[i].given);
      }
    }
    while (workers_.busy() > 0) wait();
  }

 private:
  /// Points that an earlier sweep has solved at other places, such as with fewer steps, go where
  /// this one has them. What an end in the middle of it leaves is found next time.
  void move_solved(const std::vector<SweepCase>& cases) {
    std::map<std::string, fs::path> by_text;
    for (const fs::path& point : directories()) by_text[text_of(point / "case.prm")] = point;
    std::vector<std::pair<fs::path, fs::path>> moves;
    std::error_code error;
    for (std::size_t i = 0; i < cases.size(); ++i) {
      report_.points[i].directory = fmt::format("points/{}", i + 1);
      if (!cases[i].given || is_solved(place(i), *cases[i].given)) continue;
      const auto found = by_text.find(cases[i].given->completed);
      if (found == by_text.end() || !is_solved(found->second, *cases[i].given)) continue;
      moves.emplace_back(directory_ / "points" / fmt::format("moving-{}", i + 1), place(i));
      fs::rename(found->second, moves.back().first, error);
      by_text.erase(found);
    }
    for (const auto& [from, to] : moves) {
      if (fs::exists(to / "case.prm", error)) fs::remove_all(to, error);
      fs::rename(from, to, error);
    }
  }

  /// Of points, of this sweep or of an earlier one.
  [[nodiscard]] std::vector<fs::path> directories() const {
    std::error_code error;
    std::vector<fs::path> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(directory_ / "points", error))
      if (entry.is_directory(error)) found.push_back(entry.path());
    return found;
  }

  /// Points of an earlier sweep that had more of them.
  void remove_stale() const {
    std::error_code error;
    for (const fs::path& point : directories()) {
      const std::string name = point.filename().string();
      std::size_t number = 0;
      const auto read = std::from_chars(name.data(), name.data() + name.size(), number);
      const bool is_number = read.ec == std::errc() && read.ptr == name.data() + name.size();
      if (is_number && number > report_.points.size() && fs::exists(point / "case.prm"))
        fs::remove_all(point, error);
    }
  }

  /// For the next point to end; meanwhile a terminal shows how many are solved, and for how long.
  void wait() {
    if (is_terminal(stdout))
      status_.show([count = workers_.busy()](const double elapsed) {
        return fmt::format("solving {} {}, {:.0f} s so far", count, count == 1 ? "point" : "points",
                           elapsed);
      });
    workers_.wait();
    status_.clear();
  }

  [[nodiscard]] fs::path place(const std::size_t point) const {
    return directory_ / report_.points[point].directory;
  }

  /// Whether an earlier sweep has solved this very case in a directory.
  [[nodiscard]] static bool is_solved(const fs::path& point, const Case& given) {
    const std::string mark = text_of(point / "ended");
    if (mark != mark_of(0) && mark != mark_of(not_converged)) return false;
    if (text_of(point / "case.prm") != given.completed) return false;
    const std::vector<fs::path> files = companions(given);
    return std::all_of(files.begin(), files.end(), [&](const fs::path& file) {
      return text_of(given.directory / file) == text_of(point / file);
    });
  }

  /// What is left beside a run that ended: its exit code, and who ran it.
  static std::string mark_of(const int code) {
    return fmt::format("{} {} {}\n", code, version, base::results_format);
  }

  [[nodiscard]] int stored_code(const std::size_t point) const {
    return text_of(place(point) / "ended") == mark_of(0) ? 0 : not_converged;
  }

  /// Makes the point's directory a case of its own.
  void prepare(const std::size_t point, const Case& given) const try {
    fs::create_directories(place(point));
    fs::remove(place(point) / "ended");
    fs::remove(place(point) / "log.txt");
    fs::remove_all(place(point) / "results");
    base::replace_file(place(point) / "case.prm", given.completed);
    for (const fs::path& file : companions(given)) {
      fs::create_directories((place(point) / file).parent_path());
      fs::copy_file(given.directory / file, place(point) / file,
                    fs::copy_options::overwrite_existing);
    }
  } catch (const fs::filesystem_error& error) {
    throw base::InputError(error.what());
  }

  /// A point whose directory cannot be made is told, and ends no other.
  void try_to_start(const std::size_t point, const Case& given) try {
    start(point, given);
  } catch (const base::InputError& error) {
    refuse_point(report_.points[point], error.what());
    ++done_;
    tell(report_.points[point]);
  }

  void start(const std::size_t point, const Case& given) {
    prepare(point, given);
    workers_.start({place(point), place(point) / "log.txt",
                    [this, point](const int code) { end(point, code); }});
  }

  /// Without the mark that cannot be written the point is solved again next time.
  void end(const std::size_t point, const int code) {
    try {
      if (code == 0 || code == not_converged)
        base::replace_file(place(point) / "ended", mark_of(code));
    } catch (const base::InputError& error) {
      std::cerr << for_stream(fmt::format("geneva: {}\n", error.what()), stderr);
    }
    take(point, code);
  }

  /// Reads a point's figures; a run that met a limit on its first mesh has none.
  /// @return whether there are any
  bool read_figures(const std::size_t point) {
    try {
      report_.points[point].figures = figures_of_run(place(point) / "results");
      return true;
    } catch (const base::InputError& error) {
      report_.points[point].message = error.what();
      return false;
    }
  }

  /// @param remark to the line that tells it
  void take(const std::size_t point, const int code, const std::string& remark = "") {
    post::SweepPoint& result = report_.points[point];
    result.exit_code = code;
    result.message.clear();
    const bool ended = code == 0 || code == not_converged;
    const bool is_read = !result.figures.empty() || (ended && read_figures(point));
    if (!is_read && code == 0) result.exit_code = internal_error;
    if (code != 0) result.message = complaint_in(place(point) / "log.txt");
    if (code != 0 && result.message.empty())
      result.message = fmt::format("ended with exit code {}", code);
    ++done_;
    tell(result, remark.empty() ? time_left() : remark);
  }

  /// From what the points took that were solved so far; empty where that is next to nothing.
  [[nodiscard]] std::string time_left() const {
    return pace_.time_left(done_ - kept_, to_solve_ - kept_);
  }

  void tell(const post::SweepPoint& point, const std::string& remark = "") {
    status_.clear();
    std::cout << fmt::format("{} of {}: {}{}{}\n", done_, report_.points.size(),
                             fmt::join(point.values, ", "),
                             point.message.empty() ? "" : ": " + point.message, remark)
              << std::flush;
  }

  const fs::path& directory_;
  unsigned int jobs_;
  post::SweepReport& report_;
  Workers workers_;
  std::size_t done_ = 0;
  std::size_t kept_ = 0;  ///< of those, from an earlier sweep
  std::size_t to_solve_ = 0;
  Pace pace_;
  Ticker status_;
};

}  // namespace

int sweep_case(const fs::path& case_directory, const SweepRequest& request) {
  std::vector<model::Variation> variations;
  for (const std::string& text : request.variations)
    variations.push_back(model::read_variation(text));
  const Case given = read_case(case_directory);
  std::vector<SweepCase> cases = sweep_cases(given, variations);
  Sweep sweep = begun_sweep(given, variations, cases, request.command);
  const fs::path directory =
      request.output.empty() ? sweep.given.directory / "sweep" : request.output;
  base::check_replaceable(directory);
  for (const std::string& notice : sweep.report.notices)
    std::cout << for_stream("note: " + notice, stdout) << '\n';
  if (request.command == "run") {
    check_address_space();  // of the solvers, whose every point would fail
    fs::create_directories(directory);
    const base::DirectoryLock lock(directory / ".sweeping",
                                   "sweep directory " + directory.string());
    const unsigned int cores = std::max(1U, std::thread::hardware_concurrency());
    Runs(directory, request.jobs > 0 ? request.jobs : cores, sweep.report).make(cases);
  } else {
    work_out(sweep, cases);
  }
  const auto& points = sweep.report.points;
  const auto failed =
      std::count_if(points.begin(), points.end(),
                    [](const post::SweepPoint& point) { return point.exit_code != 0; });
  require_figures(sweep);
  std::cout << '\n' << for_stream(table(sweep), stdout);
  tell_written(write(sweep, directory), "sweep.json, sweep.csv and report.html", directory,
               [](const std::string& line) { std::cout << line << '\n'; });
  if (failed == 0) return 0;
  std::cerr << for_stream(
      fmt::format("geneva: {} of {} points failed or are not as accurate as asked\n", failed,
                  points.size()),
      stderr);
  return not_converged;
}

}  // namespace geneva::app
