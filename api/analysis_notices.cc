#include "api/analysis_notices.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "api/limits.h"
#include "loads/pi.h"
#include "model/input/parameters.h"
#include "model/naming.h"
#include "model/stop_message.h"
#include "post/analysis/cut_contact.h"
#include "post/analysis/material_limits.h"
#include "post/analysis/strength_rows.h"

namespace geneva::api {

namespace {

/// What the user should know before trusting linear elasticity.
template <int dim>
std::vector<std::string> validity_notices(const fem::Solution<dim>& solution) {
  constexpr double small_strain = 0.1;
  if (!fem::has_contact(solution.problem)) return {};
  double modulus = std::numeric_limits<double>::max();
  for (const fem::Body<dim>& body : solution.problem.bodies)
    modulus = std::min(modulus, body.material.youngs_modulus);
  const double ratio = solution.history.back().peak_pressure / modulus;
  if (ratio < small_strain) return {};
  return {fmt::format(
      "the peak pressure is {:.2g} times Young's modulus: strains are not small there, and linear "
      "elasticity no longer holds; check the load and its unit",
      ratio)};
}

/// What the user should know of a contact that ends before the surfaces do.
std::vector<std::string> length_notices(const fem::Solution<2>& /*unused*/,
                                        const post::Results<2>& /*unused*/,
                                        const base::UnitSystem /*unused*/) {
  return {};
}
std::vector<std::string> length_notices(const fem::Solution<3>& solution,
                                        const post::Results<3>& results,
                                        const base::UnitSystem units) {
  constexpr double nearly_all = 0.95;
  const std::size_t leading = post::leading_contact(solution);
  const auto& sections = results.contacts[leading].sections;
  const double common =
      post::common_length(solution.contacts[leading], results.contacts[leading].frame);
  const double loaded = sections.empty() ? 0. : sections.back().z - sections.front().z;
  if (loaded > nearly_all * common) return {};
  const auto length = base::output_unit(units, base::Dimension::length);
  return {
      fmt::format("the contact is {:.4g} {} long, the surfaces face each other over {:.4g} {}: "
                  "their ends carry nothing",
                  loaded * length.factor, length.name, common * length.factor, length.name)};
}

/// What the safety factors over the cycle leave out: impacts, which no torque balance knows.
std::vector<std::string> impact_notices(const model::Case& given) {
  const bool has_limit = given.allowed.contact_pressure || given.allowed.pressure_times_slip;
  if (!given.mechanism || !has_limit) return {};
  std::vector<std::string> notices;
  for (const loads::Unbounded& place : model::driven_mechanism(*given.mechanism).unbounded())
    if (place.quantity == "wheel acceleration")
      notices.push_back(
          fmt::format("the wheel's speed jumps at a driver angle of {:.6g} deg: the safety factors "
                      "leave out that impact",
                      place.driver_angle / loads::degree));
  return notices;
}

/// "is known to 3.1 %, ..." or that it is not.
std::string known_to(const double error) {
  if (error >= 1.) return "is not known";
  return fmt::format("is known to {} %", error < 0.1 ? fmt::format("{:.2g}", 100. * error)
                                                     : fmt::format("{:.0f}", 100. * error));
}

/// Why a maximum is not as accurate as asked for.
template <int dim>
std::string why_not(const fem::StressMaximum<dim>& maximum) {
  if (maximum.may_be_hidden)
    return "cells there are longer than half of the radius of the notch that they bound: they are "
           "left to the contact, or no further mesh was allowed";
  if (maximum.is_minor)
    return "it is less than a tenth of the von Mises stress, so that no cells are spent on it";
  if (maximum.choice > maximum.error)
    return "it stands where the contact's own field still counts, so that it depends on what is "
           "taken for that field";
  return "the meshes that it may have are used up, or the next one would pass a limit such as "
         "'Maximum unknowns'";
}

/// Stresses away from the contact that are not as accurate as asked for, and why. Of one that is
/// not bounded the closing table says so.
template <int dim>
std::vector<std::string> strength_notices(const double wanted, const fem::Solution<dim>& solution) {
  std::vector<std::string> notices;
  for (const post::NamedStress<dim>& stress : post::named_stresses(solution))
    if (const double error = stress.maximum.total_error(); stress.is_bounded && error > wanted)
      notices.push_back(fmt::format(
          "the maximum {} of '{}' away from the contact {}, 'Structural accuracy' asks for {:.2g} "
          "%: {}",
          stress.name, stress.body, known_to(error), 100. * wanted, why_not(stress.maximum)));
  return notices;
}

/// Bodies whose cells may hide a greater stress, for which no accuracy was asked.
template <int dim>
std::vector<std::string> notices_of_hidden(const fem::Solution<dim>& solution) {
  std::vector<std::string> bodies;
  for (const post::NamedStress<dim>& stress : post::named_stresses(solution))
    if (stress.is_bounded && stress.maximum.may_be_hidden &&
        (bodies.empty() || bodies.back() != stress.body))
      bodies.push_back(stress.body);
  std::vector<std::string> notices;
  for (const std::string& body : bodies)
    notices.push_back(fmt::format(
        "the error of the maximum stress of '{}' away from the contact is not known, since cells "
        "there are longer than half of the radius of the notch that they bound: 'Structural "
        "accuracy = 5 %' refines them",
        body));
  return notices;
}

/// What to know of the stresses away from the contact.
template <int dim>
std::vector<std::string> strength_notices(const model::Case& given,
                                          const fem::Solution<dim>& solution) {
  if (!fem::has_contact(solution.problem)) return {};  // the run's own accuracy
  const auto wanted = given.settings.structural_accuracy;
  return wanted ? strength_notices(*wanted, solution) : notices_of_hidden(solution);
}

/// That values of a material's name are typical ones, and where they are from.
std::vector<std::string> material_notices(const model::Case& given) {
  std::vector<std::string> notices = given.notices;
  for (const auto& [body, material] : given.materials)
    notices.push_back(fmt::format(
        "'{}' of the {} stands for typical values: 'geneva materials \"{}\"' tells where they are "
        "from{}",
        material.name, body, material.name,
        material.contact_pressure ? ""
                                  : "; what its surface bears for long is not known, so that no "
                                    "limit of pitting or wear is judged"));
  return notices;
}

/// Contacts of a geometry that look as if a plane of symmetry cut them and its support were
/// missing.
template <int dim>
std::vector<std::string> cut_notices(const fem::Solution<dim>& solution) {
  std::vector<std::string> notices;
  for (const fem::ContactResult<dim>& contact : solution.contacts)
    if (const auto axis = post::cut_axis(solution, contact))
      notices.push_back(fmt::format(
          "the surface of the contact '{} -> {}' ends along {} amid the pressure: if a plane of "
          "symmetry cuts the bodies there, a support on the cut of each is missing",
          contact.source, contact.target, "xyz"[*axis]));
  return notices;
}

/// What the user should know of a pin in the round bottom of its slot, whose pressure does not only
/// turn the wheel.
template <int dim>
std::vector<std::string> bottom_notices(const fem::Solution<dim>& solution,
                                        const base::UnitSystem units) {
  constexpr double worth_saying = 0.01;
  const fem::Components<dim>& force = solution.contacts.front().force;
  const double along = std::abs(force[0]);
  if (along < worth_saying * std::abs(force[1])) return {};
  const auto unit = base::output_unit(units, base::Dimension::force);
  return {fmt::format(
      "the pin stands in the round bottom of its slot, which also presses it along the slot, by "
      "{:.4g} {}: the driver holds it there, and the contact force is the resultant of both",
      along * unit.factor, unit.name)};
}

/// That slip depends on the way to the load, of a case that gives none.
template <int dim>
std::vector<std::string> path_notices(const fem::Solution<dim>& solution) {
  if (solution.problem.steps.size() > 1) return {};
  const auto& pairs = solution.problem.pairs;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (pairs[i].friction.coefficient == 0. || pairs[i].friction.slides()) continue;
    if (solution.instants.back().pairs[i].slipping > 0)
      return {
          "the load acts in one step: slip, friction and above all its heat depend on the way to "
          "it "
          "(where bodies of different stiffness are pressed together in one step, the heat is "
          "several "
          "times too large); give 'Load steps' of ten rows or so"};
  }
  return {};
}

/// Which of finite elements and line contacts to doubt, and why.
std::string doubtful(const post::PinLineReport& line) {
  constexpr double slender = 15.;  // an ellipse then loses 0.3 % of its pressure
  const loads::PinLineContact& contact = line.contact;
  const double width = 2. * loads::peak_contact(line.pin, contact).half_width;
  if (contact.end - contact.begin < slender * width)
    return "the line contacts, which want a contact much longer than wide";
  if (loads::is_near_end(line.pin, contact))
    return "the line contacts, which know the pin as a long cylinder: an end of it is nearer to "
           "the contact than its radius";
  return "the finite elements, whose first mesh may be too coarse for the pin's bending: ask for a "
         "better accuracy";
}

template <int dim>
bool has_yield_limits(const fem::Solution<dim>& solution, const post::Results<dim>& results,
                      const model::Case& given) {
  const std::size_t leading = post::leading_contact(solution);
  const auto limits =
      post::material_limits(solution, solution.contacts[leading], results.contacts[leading],
                            given.allowed, given.mechanism->slot_friction);
  return std::any_of(limits.begin(), limits.end(), [](const loads::MaterialLimit& limit) {
    return limit.kind == loads::MaterialLimit::Kind::first_yield;
  });
}

/// To two digits.
double rounded_up(const double value) {
  const double unit = std::pow(10., std::floor(std::log10(value)) - 1.);
  return std::ceil(value / unit * (1. - 1e-12)) * unit;
}

}  // namespace

template <int dim>
std::string heading(const model::Case& given, const model::Model<dim>& model) {
  const auto length = base::output_unit(given.units, base::Dimension::length);
  const auto force = base::output_unit(given.units, base::Dimension::force);
  std::string text = model::name_of(given);
  if (!given.title.empty()) text += ": " + given.title;
  if (model.mechanism) {
    const auto& state = *model.mechanism;
    constexpr double degrees = 180. / loads::pi;
    text += fmt::format(
        "\n{}, wheel diameter {:.5g} {}, pin diameter {:.4g} {}, thickness {:.4g} {}\n"
        "driver angle {:.4f} deg, wheel acceleration {:.6g} rad/s^2, pin distance {:.5g} {}, pin "
        "force {:.6g} {}",
        state.driven.mechanism().name, state.sizes.wheel_diameter * length.factor, length.name,
        state.sizes.pin_diameter * length.factor, length.name,
        state.sizes.thickness * length.factor, length.name, state.load.driver_angle * degrees,
        state.load.wheel_acceleration, state.load.pin_distance * length.factor, length.name,
        state.load.force * force.factor, force.name);
  }
  return text;
}

template <int dim>
std::string shortfall(const fem::Solution<dim>& solution, const double accuracy) {
  if (fem::is_success(solution.stop.outcome)) return "";
  const double error = solution.error_estimate;
  const std::string reached =
      error < 1. ? fmt::format("{:.2g} %", 100. * error) : std::string("not even 100 %");
  std::string message =
      fmt::format("not converged: the accuracy reached is {}, wanted is {:.2g} %: {}", reached,
                  100. * accuracy, model::message_of(solution.stop));
  const double offered = rounded_up(error);
  if (solution.stop.outcome == fem::Outcome::unbounded_pressure ||
      offered > model::maximum_accuracy)
    return message;
  const char* const parameter =
      fem::has_contact(solution.problem) ? "Accuracy" : "Structural accuracy";
  return message + fmt::format("; or be content with '{}' = {:.2g} %", parameter, 100. * offered);
}

template <int dim>
std::vector<std::string> notices_of(const model::Case& given, const fem::Solution<dim>& solution,
                                    const post::Results<dim>& results) {
  std::vector<std::string> notices = validity_notices(solution);
  for (const std::string& notice : impact_notices(given)) notices.push_back(notice);
  const char* const left_out = given.allowed.yield_strengths.empty()
                                   ? ""
                                   : "; so are the limits of first yield and shakedown";
  for (const post::ContactAnalysis<dim>& contact : results.contacts)
    if (!contact.hertz_objection.empty()) notices.push_back(contact.hertz_objection + left_out);
  for (const std::string& notice : strength_notices(given, solution)) notices.push_back(notice);
  for (const std::string& notice : material_notices(given)) notices.push_back(notice);
  for (const std::string& notice : path_notices(solution)) notices.push_back(notice);
  if (!given.mechanism) {
    for (const std::string& notice : cut_notices(solution)) notices.push_back(notice);
    return notices;
  }
  for (const std::string& notice : bottom_notices(solution, given.units)) notices.push_back(notice);
  if (const std::string unjudged = unjudged_yield(given);
      !unjudged.empty() && !has_yield_limits(solution, results, given))
    notices.push_back("not judged: " + unjudged);
  for (const std::string& notice : length_notices(solution, results, given.units))
    notices.push_back(notice);
  return notices;
}

std::vector<std::string> line_notices(const post::PinReport& pin, const fem::Solution<3>& solution,
                                      const post::Results<3>& results) {
  if (!pin.line) return {};
  const std::size_t leading = post::leading_contact(solution);
  const auto& hertz = results.contacts[leading].hertz;
  std::vector<std::string> notices;
  if (hertz && !hertz->ellipse)
    notices.emplace_back(
        "the closed forms are those of line contacts along the pin, coupled by half-spaces and a "
        "beam: Hertz's would be an even load, which no pin has that bends, is tilted or reaches an "
        "edge");
  if (pin.line->doubt != loads::PeakDoubt::none || !post::is_bounded(solution)) return notices;
  const double expected = loads::expected_error(pin.line->pin, pin.line->contact);
  const double difference =
      solution.contacts[leading].peak_pressure / pin.line->contact.peak_pressure - 1.;
  if (std::abs(difference) > solution.error_estimate + expected)
    notices.push_back(fmt::format(
        "finite elements and line contacts along the pin differ by {:+.2g} %, more than both their "
        "errors ({:.2g} and {:.2g} %): doubt {}",
        100. * difference, 100. * solution.error_estimate, 100. * expected, doubtful(*pin.line)));
  return notices;
}

template std::string heading(const model::Case&, const model::Model<2>&);
template std::string heading(const model::Case&, const model::Model<3>&);
template std::vector<std::string> notices_of(const model::Case&, const fem::Solution<2>&,
                                             const post::Results<2>&);
template std::vector<std::string> notices_of(const model::Case&, const fem::Solution<3>&,
                                             const post::Results<3>&);
template std::string shortfall(const fem::Solution<2>&, double);
template std::string shortfall(const fem::Solution<3>&, double);

std::vector<std::string> torque_notices(const post::MechanismReport& mechanism,
                                        const base::UnitSystem units) {
  constexpr double worth_telling = 0.01;
  if (!mechanism.bore_torque) return {};
  const double expected = mechanism.expected_bore_torque;
  const double difference = std::abs(*mechanism.bore_torque - expected);
  const double moment = std::abs(mechanism.load.moment);
  if (difference < worth_telling * std::abs(expected) || moment < std::abs(expected)) return {};
  const base::OutputUnit torque = base::output_unit(units, base::Dimension::moment);
  const base::OutputUnit length = base::output_unit(units, base::Dimension::length);
  return {fmt::format(
      "the {} torque is the small rest of the pin's moment of {:.5g} {} that the wheel's own "
      "inertia leaves; the slot's wall gives way, so that the pressure leans by {:.2g} {}, and the "
      "rest is not that of a rigid wheel",
      mechanism.held_surface, moment * torque.factor, torque.name,
      difference / std::abs(mechanism.load.force) * length.factor, length.name)};
}

}  // namespace geneva::api
