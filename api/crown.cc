#include "api/crown.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "api/mechanism_picture.h"
#include "api/mesher_on_rank_zero.h"
#include "api/output_directory.h"
#include "api/version.h"
#include "base/errors.h"
#include "fem/contact_problem.h"
#include "loads/hertz.h"
#include "loads/pi.h"
#include "model/input/case_file.h"
#include "model/model.h"
#include "model/naming.h"
#include "model/pin_in_space.h"
#include "model/together.h"
#include "post/output/crown_output.h"

namespace geneva {

namespace {

using Profile = model::PinCase::Profile;

/// The search needs the line load's shape only. On the scan's coarse meshes its maximum mean is
/// off by up to 3 %, on those that follow by 0.1 %.
constexpr double search_accuracy = 0.2;
constexpr unsigned int scan_unknowns = 100000;
constexpr unsigned int search_unknowns = 400000;
/// The scan's steps, by this factor of the size, and where it begins and ends in steps.
const double scan_step = std::log(3.);
constexpr int scan_reach = 1;
constexpr int furthest_step = 6;
/// Brent's method stops when the size is known to about 5 %: the minimum is flat.
constexpr int search_bits = 6;
constexpr std::uintmax_t most_steps = 10;

void check(const model::Case& given) {
  if (!given.mechanism)
    model::refuse_model(given, "there is no pin to crown", "geneva design --crown", "mechanism");
  if (!given.mechanism->space)
    throw base::InputError(
        "'Dimension' = '2': the crown acts along the pin; 'geneva design --crown' wants a case "
        "with Dimension = 3");
  if (given.mechanism->space->profile == Profile::table)
    throw base::InputError(
        "'Pin/Profile' = 'table': it has no size to be searched for; 'crown' or 'logarithmic' is "
        "wanted");
}

bool is_logarithmic(const model::Case& given) {
  return given.mechanism->space->profile == Profile::logarithmic;
}

model::Case with_size(const model::Case& given, const double size) {
  model::Case changed = given;
  model::PinCase& pin = *changed.mechanism->space;
  if (is_logarithmic(given)) {
    pin.profile_load.reset();
    pin.profile_amplitude = size;
  } else {
    pin.profile = Profile::crown;
    pin.crown_radius = size;
  }
  return changed;
}

double drop_at_faces(const model::Case& given) {
  const model::MechanismState state = model::mechanism_state(*given.mechanism);
  loads::PinClearance profile_only;
  profile_only.profile = model::pin_clearance(*given.mechanism, state).profile;
  return profile_only.at(state.sizes.thickness / 2.);
}

/// The amplitude by which the logarithmic profile carries the pin force evenly on half-spaces, or
/// the radius of a crown that drops three times as much at the wheel's faces.
double first_size(const model::Case& given) {
  const model::MechanismCase& mechanism = *given.mechanism;
  const model::MechanismState state = model::mechanism_state(mechanism);
  const double length = mechanism.space->profile_length.value_or(state.sizes.thickness);
  const double modulus =
      loads::contact_modulus({mechanism.pin.youngs_modulus, mechanism.pin.poissons_ratio},
                             {mechanism.wheel.youngs_modulus, mechanism.wheel.poissons_ratio});
  const double amplitude = state.load.force / (loads::pi * length * modulus);
  if (is_logarithmic(given)) return amplitude;
  const double half = state.sizes.thickness / 2.;
  return half * half / (2. * 3. * amplitude);
}

/// The minimum radius of a crown: the pin must not end beyond it.
double minimum_size(const model::Case& given) {
  if (is_logarithmic(given)) return 0.;
  const model::MechanismState state = model::mechanism_state(*given.mechanism);
  const loads::PinClearance clearance = model::pin_clearance(*given.mechanism, state);
  return 1.001 * std::max(-clearance.lower_end, clearance.upper_end);
}

/// A solved case: the evenness of its line load, and whether it is as accurate as it should be.
struct SolvedPin {
  post::LoadEvenness load;
  bool is_accurate;
};

SolvedPin solve_pin(const MPI_Comm communicator, const model::Case& given,
                    const fem::Settings& settings, mesh::Mesher* const mesher) {
  const model::Model<3> model = model::make_model<3>(communicator, given, mesher);
  const fem::Solution<3> solution =
      fem::solve_contact(communicator, model.mesh, model.problem, settings, {});
  return {post::load_evenness(solution, post::analyse(solution)),
          fem::is_success(solution.stop.outcome)};
}

using Ratio = std::function<double(double)>;

/// Logarithms of two sizes with that of the minimum ratio in between: a scan by equal factors,
/// begun around the first size and carried on while its minimum value is at an end.
/// @param first >= least
std::pair<double, double> scan(const double first, const double least, const Ratio& ratio_at) {
  const auto at = [&](const int step) { return std::log(first) + step * scan_step; };
  const auto is_allowed = [&](const int step) { return step == 0 || std::exp(at(step)) >= least; };
  std::map<int, double> ratios;
  const auto best = [&] {
    return std::min_element(ratios.begin(), ratios.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; });
  };
  for (int step = -scan_reach; step <= scan_reach; ++step)
    if (is_allowed(step)) ratios[step] = ratio_at(std::exp(at(step)));
  for (int step = best()->first; std::abs(step) < furthest_step; step = best()->first) {
    const int next = step == ratios.begin()->first    ? step - 1
                     : step == ratios.rbegin()->first ? step + 1
                                                      : step;
    if (next == step || !is_allowed(next)) break;
    ratios[next] = ratio_at(std::exp(at(next)));
  }
  const int below = best()->first - 1;
  return {is_allowed(below) ? at(below) : std::log(least), at(best()->first + 1)};
}

/// The size of the minimum ratio by Brent's method.
double minimum_uneven(const std::pair<double, double>& logarithms, const Ratio& ratio_at) {
  std::uintmax_t steps = most_steps;
  const auto [logarithm, ratio] = boost::math::tools::brent_find_minima(
      [&](const double at) { return ratio_at(std::exp(at)); }, logarithms.first, logarithms.second,
      search_bits, steps);
  return std::exp(logarithm);
}

post::CrownReport search(const MPI_Comm communicator, const model::Case& given, const Tell& tell,
                         mesh::Mesher* const mesher) {
  post::CrownReport report{};
  report.about = model::header_of(given);
  report.geneva_version = version;
  report.profile = is_logarithmic(given) ? "logarithmic" : "crown";
  report.parameter = is_logarithmic(given) ? "Profile amplitude" : "Crown radius";
  const base::OutputUnit length = base::output_unit(given.units, base::Dimension::length);
  const auto ratio_with = [&](const unsigned int unknowns, const bool is_scan) {
    fem::Settings settings = given.settings;
    settings.accuracy = std::max(search_accuracy, settings.accuracy);
    settings.max_dofs = std::min(unknowns, settings.max_dofs);
    return [&, settings, is_scan](const double size) {
      const double ratio =
          solve_pin(communicator, with_size(given, size), settings, mesher).load.ratio();
      report.trials.push_back({size, ratio, is_scan});
      tell(fmt::format("{} {:>10.4g} {}: maximum over even line load {:.4f}", report.parameter,
                       size * length.factor, length.name, ratio));
      return ratio;
    };
  };
  const double least = minimum_size(given);
  const auto range =
      scan(std::max(first_size(given), least), least, ratio_with(scan_unknowns, true));
  tell("on finer meshes");
  report.size = minimum_uneven(range, ratio_with(search_unknowns, false));
  return report;
}

void no_progress(const std::string& /*text*/) {}

}  // namespace

Crown design_crown(const Case& given, const MPI_Comm communicator, const Tell& progress,
                   mesh::Mesher* const started) {
  const Tell tell = progress ? progress : no_progress;
  api::MesherOnRankZero on_rank_zero(communicator, started);
  mesh::Mesher* const mesher = on_rank_zero.get();
  return model::naming(given, [&] {
    check(given);
    post::CrownReport report = search(communicator, given, tell, mesher);
    tell("solving both pins as accurately as the case asks");
    const SolvedPin before = solve_pin(communicator, given, given.settings, mesher);
    const model::Case changed = with_size(given, report.size);
    const SolvedPin after = solve_pin(communicator, changed, given.settings, mesher);
    report.before = before.load;
    report.after = after.load;
    report.drop = drop_at_faces(changed);
    return Crown{given, std::move(report), before.is_accurate && after.is_accurate};
  });
}

std::string table(const Crown& crown) { return post::crown_table(crown.report, crown.given.units); }

Written write(const Crown& crown, const std::filesystem::path& directory) {
  const auto& [given, report, is_accurate] = crown;
  return api::write_results(directory, given, "crown",
                            {{"crown.json", post::crown_summary(report).dump(2) + "\n"},
                             {"crown.csv", post::crown_csv(report, given.units)},
                             {"mechanism.json", api::mechanism_text(*given.mechanism)}});
}

}  // namespace geneva
