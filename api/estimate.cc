#include "api/estimate.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "api/engagement.h"
#include "api/limits.h"
#include "api/mechanism_picture.h"
#include "api/output_directory.h"
#include "api/version.h"
#include "loads/held_cylinder.h"
#include "model/block_dimensions.h"
#include "model/case_header.h"
#include "model/mechanism_state.h"
#include "model/naming.h"
#include "model/pin_in_space.h"

namespace geneva {

namespace {

using base::Dimension;
using Rows = std::vector<post::EstimateRow>;

constexpr const char* by_hertz = "Hertz";
constexpr const char* by_lines = "half-space and beam";

void append_hertz(Rows& rows, const loads::HertzLine& hertz, const loads::DeepStress& shear,
                  const std::string& basis, const std::string& basis_of_shear) {
  rows.push_back({"peak contact pressure", Dimension::stress, hertz.peak_pressure, basis});
  rows.push_back({"half-width", Dimension::length, hertz.half_width, basis});
  rows.push_back({"maximum shear", Dimension::stress, shear.value, basis_of_shear});
  rows.push_back({"its depth", Dimension::length, shear.depth, basis_of_shear});
}

void append_expected_error(post::EstimateReport& report, const double error) {
  report.expected_error = error;
  report.rows.push_back({"expected error of the peak, percent", Dimension::dimensionless,
                         100. * error, "beside finite elements"});
}

/// The contact in the plane: Hertz's pressure, and the shear below it in a pin of finite size.
///
/// The pressure of wheels and pins of finite size differs from Hertz's by a share of the order
/// (b/R)^2: of 168 random ones by at most 2.5 times that (0.01 % at least) and the finite elements'
/// own error, see doc/validation.md.
void append_plane(post::EstimateReport& report, const model::MechanismCase& mechanism,
                  const model::MechanismState& state) {
  constexpr double of_square = 2.5;
  constexpr double least_error = 1e-4;
  const loads::HertzLine& hertz = report.even;
  const loads::DeepStress in_half_plane{hertz.max_shear, hertz.max_shear_depth};
  const double radius = report.relative_radius;
  const double core = model::block_dimensions(mechanism, state.sizes).pin_core_radius;
  const bool is_known = !mechanism.space && !model::reaches_bottom(mechanism, state) &&
                        hertz.half_width < 0.1 * radius;
  if (!is_known || mechanism.bore_clearance || core > 0.9 * radius)
    append_hertz(report.rows, hertz, in_half_plane, by_hertz, by_hertz);
  else
    append_hertz(
        report.rows, hertz,
        loads::maximum_shear_in_held_cylinder(hertz, radius, core, mechanism.pin.poissons_ratio),
        by_hertz, "Hertz in the held pin");
  if (is_known)
    append_expected_error(
        report, std::max(least_error, of_square * std::pow(hertz.half_width / radius, 2)));
}

/// The contact of a pin that bends.
void append_line(post::EstimateReport& report, const loads::PinLine& pin) {
  const loads::PinLineContact& line = *report.line;
  Rows& rows = report.rows;
  const auto section = [&](const double line_load) {
    return loads::hertz_line(line_load, report.relative_radius, report.contact_modulus);
  };
  rows.push_back(
      {"Johnson's Eq. 2, even load", Dimension::stress, report.even.peak_pressure, by_hertz});
  if (report.doubt == loads::PeakDoubt::none) {
    const loads::HertzLine peak = loads::peak_contact(pin, line);
    append_hertz(rows, peak, {peak.max_shear, peak.max_shear_depth}, by_lines, by_lines);
    append_expected_error(report, loads::expected_error(pin, line));
    rows.push_back(
        {"place of the peak along the pin", Dimension::length, line.peak_place, by_lines});
    rows.push_back({"length of the contact", Dimension::length, line.end - line.begin, by_lines});
    rows.push_back({"peak over Johnson's Eq. 2", Dimension::dimensionless,
                    line.peak_pressure / report.even.peak_pressure, by_lines});
  } else {
    const double load = loads::line_load_at(line, 0.);
    rows.push_back({"pressure in the middle", Dimension::stress,
                    load > 0. ? section(load).peak_pressure : 0., by_lines});
    rows.push_back({"line load, middle", Dimension::force_per_length, load, by_lines});
  }
  if (pin.hold == loads::PinHold::core) return;
  if (loads::is_beam(pin))
    rows.push_back({"bending stress at the root", Dimension::stress, line.root_stress, by_lines});
  else
    report.left_out.emplace_back(
        "the bending stress where the pin is held: it is too short for a beam that is held twice");
  if (pin.hold == loads::PinHold::both_ends) return;
  if (loads::is_near_end(pin, line))
    report.left_out.emplace_back(
        "what the pin's ends change: one is nearer to the contact than its radius; deflection and "
        "slope are up to 7 % off");
  rows.push_back({"pin deflection", Dimension::length, line.deflection, "beam"});
  rows.push_back({"pin slope in the slot", Dimension::slope, line.slope, "beam"});
}

/// The greatest pressure over the engagements, by the best that is known of each angle; none in 3-D
/// where line contacts know no peak at some of them: Hertz's even load is no answer to edges.
void append_engagement(post::EstimateReport& report) {
  const auto is_unknown = [](const post::EngagementPoint& point) { return !point.peak_pressure; };
  if (report.line && std::any_of(report.engagement.begin(), report.engagement.end(), is_unknown)) {
    report.left_out.emplace_back(
        "the greatest pressure of the engagement, and limits of it: line contacts have no peak at "
        "all of its driver angles");
    return;
  }
  const auto pressure = [](const post::EngagementPoint& point) {
    return point.peak_pressure.value_or(point.even_pressure);
  };
  const auto& points = report.engagement;
  const auto worst =
      std::max_element(points.begin(), points.end(),
                       [&](const auto& a, const auto& b) { return pressure(a) < pressure(b); });
  if (worst == points.end()) return;
  const char* const basis = worst->peak_pressure ? by_lines : by_hertz;
  report.rows.push_back(
      {"greatest pressure of the engagement", Dimension::stress, pressure(*worst), basis});
  report.rows.push_back({"its driver angle", Dimension::angle, worst->driver_angle, basis});
}

/// Limits of the greatest pressure of the cycle, in 3-D where line contacts know it.
std::vector<post::LimitRow> limits_of(const Case& given, const model::MechanismState& state,
                                      const loads::PinContact& contact) {
  const loads::Characteristics cycle = loads::characteristics(state.driven, state.train, contact);
  const auto pressure = api::limited_pressure(*given.mechanism, cycle);
  if (!pressure) return {};
  return api::pressure_limits(given, contact, *pressure);
}

void append_strength(post::EstimateReport& report, const loads::Allowables& allowed,
                     const bool has_root, const bool has_stud) {
  const bool has_peak = report.line && report.doubt == loads::PeakDoubt::none;
  const double pressure = has_peak ? report.line->peak_pressure : report.even.peak_pressure;
  if (allowed.contact_pressure && (has_peak || !report.line))
    report.rows.push_back({"safety factor of the contact pressure", Dimension::dimensionless,
                           *allowed.contact_pressure / pressure, "Contact pressure allowed"});
  const auto yield = allowed.yield_strengths.find("pin");
  if (has_root && !has_stud && report.line->root_stress > 0. &&
      yield != allowed.yield_strengths.end())
    report.rows.push_back({"safety factor of the pin's root", Dimension::dimensionless,
                           yield->second / report.line->root_stress, "Yield strength"});
}

std::string sentence_of(const loads::PeakDoubt doubt) {
  switch (doubt) {
    case loads::PeakDoubt::reaches_edge:
      return "the pressure at the ends: the contact reaches the wall's edge, where line contacts "
             "have no peak (of a rounded one they have)";
    case loads::PeakDoubt::at_profile_end:
      return "the peak pressure: it is at the end of the logarithmic profile, which falls within "
             "the contact's width";
    case loads::PeakDoubt::not_settled:
      return "the peak pressure: it changes with the number of sections";
    case loads::PeakDoubt::none:
      break;
  }
  return "";
}

/// In 3-D a roller is a solid pin, which bends less than the stud that it turns on.
void leave_out_stud(post::EstimateReport& report) {
  const auto of_pin = [](const post::EstimateRow& row) {
    return row.quantity == "bending stress at the root" || row.quantity == "pin deflection" ||
           row.quantity == "pin slope in the slot";
  };
  auto& rows = report.rows;
  const auto kept = std::remove_if(rows.begin(), rows.end(), of_pin);
  if (kept == rows.end()) return;
  rows.erase(kept, rows.end());
  report.left_out.emplace_back(
      "deflection of the roller's stud, and what it does to the pressure at the wall's edges");
}

void append_stud(post::EstimateReport& report, const model::MechanismCase& mechanism,
                 const model::MechanismState& state) {
  if (const auto beam = model::pin_beam(mechanism, state.sizes))
    report.rows.push_back({"bending stress at the stud's root", Dimension::stress,
                           loads::beam_bending(*beam, std::abs(state.load.force)).root_stress,
                           "beam"});
}

void append_left_out(post::EstimateReport& report, const model::MechanismCase& mechanism,
                     const bool is_in_bottom, const bool has_friction) {
  std::vector<std::string>& sentences = report.left_out;
  sentences.emplace_back(
      report.line
          ? "all stresses away from the contact ('geneva run' has them)"
          : "what the wheel adds to the shear below the contact, and all stresses away from it "
            "('geneva run' has them)");
  if (!mechanism.space && is_in_bottom)
    sentences.emplace_back(
        "the round bottom of the slot, where the pin stands: Hertz's contact is that of a straight "
        "wall");
  if (mechanism.space && !report.line)
    sentences.emplace_back(
        "bending, profile and edges: no model without finite elements for a pin in the round "
        "bottom of its slot, with a bore of more than 0.7 of its diameter, or with a negative "
        "Poisson's ratio");
  if (report.doubt != loads::PeakDoubt::none) sentences.push_back(sentence_of(report.doubt));
  if (mechanism.roller) leave_out_stud(report);
  if (has_friction)
    sentences.emplace_back("friction in the stresses: the maximum shear is that without it");
}

post::EstimateReport estimate_report(const Case& given) {
  if (!given.mechanism)
    model::refuse_model(given, "there is no Geneva mechanism", "geneva estimate", "mechanism");
  const model::MechanismCase& mechanism = *given.mechanism;
  const model::MechanismState state = model::mechanism_state(mechanism);
  const loads::PinContact contact = api::pin_contact(mechanism, state.sizes);
  post::EstimateReport report{};
  report.about = model::header_of(given);
  report.geneva_version = version;
  report.mechanism = state.driven.mechanism().name;
  report.load = state.load;
  report.relative_radius = state.sizes.pin_diameter / 2.;
  report.contact_modulus = contact.contact_modulus;
  report.poissons_ratio = std::min(mechanism.pin.poissons_ratio, mechanism.wheel.poissons_ratio);
  report.even_line_load = state.load.force / state.sizes.thickness;
  report.even =
      loads::hertz_line(report.even_line_load, report.relative_radius, report.contact_modulus);
  const bool has_friction = loads::friction_along_wall(state.train) > 0.;
  report.rows = {{"pin force", Dimension::force, state.load.force,
                  has_friction ? "F = (J a + M)/(r - mu e)" : "F = (J a + M)/r"}};
  const auto known = model::pin_line_contact(mechanism, state);
  if (known) {
    report.line = known->contact;
    report.doubt = loads::peak_doubt(known->pin, known->contact);
    report.wheel_twist = known->pin.wheel_twist;
    append_line(report, known->pin);
  } else {
    append_plane(report, mechanism, state);
  }
  report.engagement =
      api::engagement(mechanism, state, known ? std::optional(known->pin) : std::nullopt);
  append_engagement(report);
  report.limits = limits_of(given, state, contact);
  append_strength(report, given.allowed, known && loads::is_beam(known->pin),
                  mechanism.roller.has_value());
  append_left_out(report, mechanism, model::reaches_bottom(mechanism, state), has_friction);
  if (mechanism.roller) append_stud(report, mechanism, state);
  if (const std::string unjudged = api::unjudged_yield(given); !unjudged.empty())
    report.left_out.push_back(unjudged);
  return report;
}

}  // namespace

Estimate estimate(const Case& given) {
  return model::naming(given, [&] {
    post::EstimateReport report = estimate_report(given);
    std::vector<std::string> notices = given.notices;
    for (const std::string& notice : model::notices_of(*given.mechanism, given.units))
      notices.push_back(notice);
    return Estimate{given, std::move(report), std::move(notices)};
  });
}

std::string table(const Estimate& estimate) {
  return post::estimate_table(estimate.report, estimate.given.units);
}

Written write(const Estimate& estimate, const std::filesystem::path& directory) {
  const auto& [given, report, notices] = estimate;
  return api::write_results(directory, given, "estimate",
                            {{"estimate.json", post::estimate_summary(report).dump(2) + "\n"},
                             {"estimate.csv", post::estimate_csv(report, given.units)},
                             {"mechanism.json", api::mechanism_text(*given.mechanism)}});
}

}  // namespace geneva
