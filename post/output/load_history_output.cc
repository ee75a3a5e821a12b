#include "post/output/load_history_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace geneva::post {

using base::Dimension;
using base::output_unit;
using base::OutputUnit;
using base::quantity;
using base::UnitSystem;
using nlohmann::json;

namespace {

constexpr std::array<const char*, 3> axes{"x", "y", "z"};
constexpr double round_off = 1e-9;  // relative

double length_of(const std::array<double, 3>& vector) {
  return std::hypot(vector[0], vector[1], vector[2]);
}

/// Without round-off where it is none.
double friction_of(const ContactAtStep& contact) {
  const double friction = length_of(contact.friction_force);
  return friction > round_off * length_of(contact.force) ? friction : 0.;
}

json vector_json(const std::array<double, 3>& vector, const Dimension dimension) {
  json components = json::array();
  for (const double component : vector) components.push_back(quantity(component, dimension));
  return components;
}

json step_json(const LoadStepPoint& point, const std::size_t number) {
  json contacts = json::array();
  for (const ContactAtStep& contact : point.contacts)
    contacts.push_back(
        {{"source", contact.source},
         {"target", contact.target},
         {"force", vector_json(contact.force, Dimension::force)},
         {"friction_force", vector_json(contact.friction_force, Dimension::force)},
         {"peak_pressure", quantity(contact.peak_pressure, Dimension::stress)},
         {"half_width", quantity(contact.half_width, Dimension::length)},
         {"change_from_mesh_before", contact.change ? json(*contact.change) : json()},
         {"sticking_nodes", contact.sticking},
         {"slipping_nodes", contact.slipping},
         {"dissipated", quantity(contact.dissipated, "J")}});
  json stresses = json::array();
  for (const StressAtStep& stress : point.stresses)
    stresses.push_back({{"body", stress.body},
                        {"von_mises", quantity(stress.von_mises, Dimension::stress)},
                        {"first_principal", quantity(stress.first_principal, Dimension::stress)}});
  return {{"step", number},
          {"time", quantity(point.time, Dimension::time)},
          {"contacts", contacts},
          {"stresses", stresses},
          {"work", quantity(point.work, "J")},
          {"elastic_energy", quantity(point.stored, "J")}};
}

json greatest_json(const LoadHistoryReport& report) {
  const auto greatest = greatest_pressure(report);
  if (!greatest) return nullptr;
  const ContactAtStep& contact = report.steps[greatest->step].contacts[greatest->contact];
  return {{"step", greatest->step + 1},
          {"source", contact.source},
          {"target", contact.target},
          {"peak_pressure", quantity(contact.peak_pressure, Dimension::stress)},
          {"change_from_mesh_before", contact.change ? json(*contact.change) : json()}};
}

std::string change_text(const std::optional<double>& change) {
  return change ? fmt::format("{:+.2g} %", 100. * *change) : "-";
}

}  // namespace

std::optional<GreatestAtStep> greatest_pressure(const LoadHistoryReport& report) {
  std::optional<GreatestAtStep> greatest;
  double pressure = 0.;
  for (std::size_t step = 0; step < report.steps.size(); ++step)
    for (std::size_t i = 0; i < report.steps[step].contacts.size(); ++i) {
      const double here = report.steps[step].contacts[i].peak_pressure;
      if (here == 0. || here < pressure * (1. - round_off)) continue;
      pressure = std::max(here, pressure);
      greatest = {step, i};
    }
  return greatest;
}

json load_history_summary(const LoadHistoryReport& report) {
  json steps = json::array();
  for (std::size_t i = 0; i < report.steps.size(); ++i)
    steps.push_back(step_json(report.steps[i], i + 1));
  return {{"case", base::case_section(report.about)},
          {"versions", base::versions_section(report.geneva_version)},
          {"accuracy", report.accuracy},
          {"error_of_last_step", report.error ? json(*report.error) : json()},
          {"bounded", report.is_bounded},
          {"greatest", greatest_json(report)},
          {"safety", limits_section(report.limits)},
          {"steps", steps},
          {"notices", report.notices},
          {"seconds", report.seconds},
          {"ranks", report.ranks}};
}

std::string load_history_csv(const LoadHistoryReport& report, const UnitSystem units) {
  const OutputUnit force = output_unit(units, Dimension::force);
  const OutputUnit stress = output_unit(units, Dimension::stress);
  const OutputUnit length = output_unit(units, Dimension::length);
  std::string text = "step,time [s],pair";
  for (const char* const name : {"force", "friction_force"})
    for (const char* const axis : axes) text += fmt::format(",{}_{} [{}]", name, axis, force.name);
  text += fmt::format(
      ",peak_pressure [{}],half_width "
      "[{}],change_from_mesh_before,sticking_nodes,slipping_nodes,dissipated [J],"
      "work [J],elastic_energy [J]\n",
      stress.name, length.name);
  for (std::size_t i = 0; i < report.steps.size(); ++i) {
    const LoadStepPoint& point = report.steps[i];
    for (const ContactAtStep& contact : point.contacts) {
      text += fmt::format("{},{:.9g},{} -> {}", i + 1, point.time, contact.source, contact.target);
      for (const auto* const vector : {&contact.force, &contact.friction_force})
        for (const double component : *vector)
          text += fmt::format(",{:.9g}", component * force.factor);
      text += fmt::format(",{:.9g},{:.9g},{},{},{},{:.9g},{:.9g},{:.9g}\n",
                          contact.peak_pressure * stress.factor, contact.half_width * length.factor,
                          contact.change ? fmt::format("{:.3g}", *contact.change) : "",
                          contact.sticking, contact.slipping, contact.dissipated, point.work,
                          point.stored);
    }
  }
  return text;
}

std::string load_history_table(const LoadHistoryReport& report, const UnitSystem units) {
  const OutputUnit force = output_unit(units, Dimension::force);
  const OutputUnit stress = output_unit(units, Dimension::stress);
  std::string text =
      fmt::format("{:>4} {:>10} {:>14} {:>14} {:>14} {:>16} {:>6} {:>6} {:>12}  {}\n", "step",
                  "time s", fmt::format("force {}", force.name),
                  fmt::format("friction {}", force.name), fmt::format("peak {}", stress.name),
                  "from mesh before", "stick", "slip", "heat J", "contact");
  for (std::size_t i = 0; i < report.steps.size(); ++i)
    for (const ContactAtStep& contact : report.steps[i].contacts)
      text += fmt::format(
          "{:>4} {:>10.4g} {:>14.6g} {:>14.6g} {:>14.6g} {:>16} {:>6} {:>6} "
          "{:>12.5g}  {} -> {}\n",
          i + 1, report.steps[i].time, length_of(contact.force) * force.factor,
          friction_of(contact) * force.factor, contact.peak_pressure * stress.factor,
          change_text(contact.change), contact.sticking, contact.slipping, contact.dissipated,
          contact.source, contact.target);
  if (const auto greatest = greatest_pressure(report)) {
    const ContactAtStep& contact = report.steps[greatest->step].contacts[greatest->contact];
    const bool is_last = greatest->step + 1 == report.steps.size();
    text += fmt::format("greatest peak pressure{}: {:.6g} {}{} at step {} of {}, {} -> {}\n",
                        report.is_bounded ? "" : ", not bounded, on the last mesh",
                        contact.peak_pressure * stress.factor, stress.name,
                        report.is_bounded && is_last && report.error
                            ? fmt::format(" +- {:.2g} %", 100. * *report.error)
                            : "",
                        greatest->step + 1, report.steps.size(), contact.source, contact.target);
  }
  return text + limit_lines(report.limits, units);
}

}  // namespace geneva::post
