#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "post/output/cycle_output.h"
#include "post/output/kinematics_output.h"

namespace geneva::post {

using base::Dimension;
using base::quantity;
using nlohmann::json;

namespace {

json stress_json(const CycleStress& stress) {
  return {
      {"body", stress.body},
      {"quantity", stress.name},
      {"value", quantity(stress.value, Dimension::stress)},
      {"error", stress.error},
      {"where", stress.where},
      {"place",
       {quantity(stress.place[0], Dimension::length), quantity(stress.place[1], Dimension::length),
        quantity(stress.place[2], Dimension::length)}},
      {"body_index", stress.body_index}};
}

json contact_json(const CycleContact& contact) {
  json stresses = json::array();
  for (const CycleStress& stress : contact.stresses) stresses.push_back(stress_json(stress));
  return {{"peak_pressure", quantity(contact.peak_pressure, Dimension::stress)},
          {"error", contact.error},
          {"half_width", quantity(contact.half_width, Dimension::length)},
          {"bore_torque",
           contact.bore_torque ? quantity(*contact.bore_torque, Dimension::moment) : json()},
          {"expected_bore_torque", quantity(contact.expected_bore_torque, Dimension::moment)},
          {"stresses", stresses},
          {"hertz_objection", contact.hertz_objection},
          {"shortfall", contact.shortfall},
          {"seconds", contact.seconds}};
}

json point_json(const CyclePoint& point) {
  const loads::PinLoad& load = point.instant.load;
  return {{"role", loads::name_of(point.instant.role)},
          {"engagement", point.instant.engagement + 1},
          {"time", quantity(load.time, Dimension::time)},
          {"driver_angle", quantity(load.driver_angle, Dimension::angle)},
          {"wall", name_of(load.wall)},
          {"pin_force", quantity(std::abs(load.force), Dimension::force)},
          {"pin_distance", quantity(load.pin_distance, Dimension::length)},
          {"slip_speed", quantity(load.slip_speed, Dimension::speed)},
          {"hertz_pressure", quantity(point.hertz_pressure, Dimension::stress)},
          {"contact", point.contact ? contact_json(*point.contact) : json()},
          {"refusal", point.refusal}};
}

json curve_json(const std::vector<CycleCurvePoint>& curve) {
  json columns = {{"driver_angle", json::array()},   {"pin_force", json::array()},
                  {"hertz_pressure", json::array()}, {"peak_pressure", json::array()},
                  {"slip_speed", json::array()},     {"pin_distance", json::array()},
                  {"pin_turn", json::array()},       {"wall_heat", json::array()},
                  {"pin_heat", json::array()}};
  for (const CycleCurvePoint& point : curve) {
    columns["driver_angle"].push_back(point.driver_angle);
    columns["pin_force"].push_back(point.force);
    columns["hertz_pressure"].push_back(point.hertz_pressure);
    columns["peak_pressure"].push_back(base::finite(point.peak_pressure));
    columns["slip_speed"].push_back(point.slip_speed);
    columns["pin_distance"].push_back(point.pin_distance);
    columns["pin_turn"].push_back(point.pin_turn);
    columns["wall_heat"].push_back(base::finite(point.wall_heat));
    columns["pin_heat"].push_back(base::finite(point.pin_heat));
  }
  return columns;
}

json work_json(const CycleWork& work) {
  const auto joule = [](const double value) { return quantity(value, "J"); };
  return {{"pin", joule(work.pin)},
          {"energy_change", joule(work.energy_change)},
          {"driving", joule(work.driving)},
          {"friction", joule(work.friction)},
          {"driving_efficiency",
           work.driving > 0. ? json(work.driving / (work.driving + work.friction)) : json()}};
}

json ranges_json(const CycleReport& report) {
  json list = json::array();
  for (const CycleStressRange& range : stress_ranges(report)) {
    json entry = stress_json(range.greatest);
    entry["driver_angle"] = quantity(range.driver_angle, Dimension::angle);
    if (range.swing) {
      entry["least"] = quantity(range.swing->least, Dimension::stress);
      entry["least_driver_angle"] = range.swing->driver_angle
                                        ? quantity(*range.swing->driver_angle, Dimension::angle)
                                        : json();
    }
    entry["range"] = quantity(range.range(), Dimension::stress);
    list.push_back(std::move(entry));
  }
  return list;
}

}  // namespace

std::string solved_text(const CyclePoint& point) {
  return json{{"contact", point.contact ? contact_json(*point.contact) : json()},
              {"refusal", point.refusal}}
      .dump();
}

void take_over(CyclePoint& point, const std::string& solved) {
  const json document = json::parse(solved);
  point.refusal = document.at("refusal");
  point.contact.reset();
  const json& found = document.at("contact");
  if (found.is_null()) return;
  const auto number = [](const json& quantity) { return quantity.at("value").get<double>(); };
  CycleContact contact{};
  contact.peak_pressure = number(found.at("peak_pressure"));
  contact.error = found.at("error");
  contact.half_width = number(found.at("half_width"));
  if (!found.at("bore_torque").is_null()) contact.bore_torque = number(found.at("bore_torque"));
  contact.expected_bore_torque = number(found.at("expected_bore_torque"));
  for (const json& stress : found.at("stresses")) {
    const json& place = stress.at("place");
    contact.stresses.push_back({stress.at("body"),
                                stress.at("quantity"),
                                number(stress.at("value")),
                                stress.at("error"),
                                stress.at("where"),
                                {number(place[0]), number(place[1]), number(place[2])},
                                stress.at("body_index")});
  }
  contact.hertz_objection = found.at("hertz_objection");
  contact.shortfall = found.at("shortfall");
  contact.seconds = found.at("seconds");
  point.contact = std::move(contact);
}

json cycle_summary(const CycleReport& report) {
  json points = json::array();
  for (const CyclePoint& point : report.points) points.push_back(point_json(point));
  json changes = json::array();
  for (const double angle : report.wall_changes)
    changes.push_back(quantity(angle, Dimension::angle));
  const CyclePoint* const greatest = greatest_pressure(report);
  return {{"case", base::case_section(report.about)},
          {"versions", base::versions_section(report.geneva_version)},
          {"mechanism", report.mechanism},
          {"accuracy", report.accuracy},
          {"greatest", greatest != nullptr ? point_json(*greatest) : json()},
          {"stresses", ranges_json(report)},
          {"safety", limits_section(report.limits)},
          {"instants", points},
          {"curve", curve_json(report.curve)},
          {"wall_changes", changes},
          {"equal_engagements", report.left_out},
          {"work", work_json(report.work)},
          {"notices", report.notices},
          {"seconds", report.seconds},
          {"ranks", report.ranks}};
}

}  // namespace geneva::post
