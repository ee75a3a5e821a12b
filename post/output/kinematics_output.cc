#include "post/output/kinematics_output.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/json_values.h"

namespace geneva::post {

using base::case_section;
using base::Dimension;
using base::finite;
using base::output_unit;
using base::OutputUnit;
using base::quantity;
using base::UnitSystem;
using base::versions_section;

using loads::KinematicsRow;
using loads::PlacedPeak;
using nlohmann::json;

namespace {

/// Roundings and minus signs of what is 0.
double shown(const double value) { return std::abs(value) < 1e-12 ? 0. : value; }

json unbounded_section(const std::vector<loads::Unbounded>& places) {
  json list = json::array();
  for (const loads::Unbounded& place : places)
    list.push_back({{"quantity", place.quantity},
                    {"driver_angle", quantity(place.driver_angle, "rad")},
                    {"time", quantity(place.time, "s")},
                    {"cause", place.cause}});
  return list;
}

/// What is 0 all the way has no place.
void add_peak(json& result, const std::string& name, const PlacedPeak& peak, const char* unit) {
  result[name] = quantity(peak.value, unit);
  result[name + "_angle"] = peak.value > 0. ? quantity(peak.driver_angle, "rad") : json(nullptr);
}

/// Builds the rows.
class Rows {
 public:
  void add(const std::string& quantity, const double value, const Dimension dimension) {
    list_.push_back({quantity, dimension, value, std::nullopt});
  }
  void add(const std::string& quantity, const PlacedPeak& peak, const Dimension dimension) {
    list_.push_back({quantity, dimension, peak.value,
                     peak.value > 0. ? std::optional(peak.driver_angle) : std::nullopt});
  }
  void add_if_finite(const std::string& quantity, const double value) {
    if (std::isfinite(value)) add(quantity, value, Dimension::dimensionless);
  }
  [[nodiscard]] const std::vector<CharacteristicRow>& list() const { return list_; }

 private:
  std::vector<CharacteristicRow> list_;
};

void add_forces(Rows& rows, const loads::Characteristics& values) {
  const std::string ratio = "  over that at the maximum acceleration";
  rows.add("maximum pin force", values.force, Dimension::force);
  rows.add_if_finite(ratio, values.force_ratio);
  if (values.braking_force.value > 0.)
    rows.add("maximum force on the braking wall", values.braking_force, Dimension::force);
  rows.add("maximum Hertz pressure", values.pressure, Dimension::stress);
  rows.add_if_finite(ratio, values.pressure_ratio);
  rows.add("maximum pressure x slip", values.pressure_times_slip, Dimension::pressure_times_speed);
  rows.add_if_finite(ratio, values.pressure_times_slip_ratio);
  if (values.bore_pressure_times_speed.value > 0.)
    rows.add("maximum mean bore pressure x sliding speed", values.bore_pressure_times_speed,
             Dimension::pressure_times_speed);
  for (const loads::SlipReversal& reversal : values.slip_reversals)
    rows.add(fmt::format("slip reverses on the {} wall at", name_of(reversal.wall)),
             reversal.driver_angle, Dimension::angle);
}

json reversals_section(const std::vector<loads::SlipReversal>& reversals) {
  json list = json::array();
  for (const loads::SlipReversal& reversal : reversals)
    list.push_back({{"wall", name_of(reversal.wall)},
                    {"driver_angle", quantity(reversal.driver_angle, "rad")}});
  return list;
}

json characteristics_section(const KinematicsReport& report) {
  json list = json::array();
  for (const CharacteristicRow& row : characteristic_rows(report.values, report.reference_speed))
    list.push_back({{"quantity", row.quantity},
                    {"dimension", name_of(row.dimension)},
                    {"value", quantity(row.value, row.dimension)},
                    {"driver_angle",
                     row.driver_angle ? quantity(*row.driver_angle, Dimension::angle) : json()}});
  return list;
}

std::string line_of(const CharacteristicRow& row, const UnitSystem units) {
  const OutputUnit unit = output_unit(units, row.dimension);
  const OutputUnit angle = output_unit(units, Dimension::angle);
  const std::string place =
      row.driver_angle
          ? fmt::format("  at {:.5g} {}", shown(*row.driver_angle) * angle.factor, angle.name)
          : "";
  return fmt::format(
      "{:<52} {:>12}{}\n",
      unit.name.empty() ? row.quantity : fmt::format("{} [{}]", row.quantity, unit.name),
      fmt::format("{:.6g}", shown(row.value) * unit.factor), place);
}

}  // namespace

const char* name_of(const loads::Wall wall) {
  switch (wall) {
    case loads::Wall::driving:
      return "driving";
    case loads::Wall::braking:
      return "braking";
    case loads::Wall::none:
      break;
  }
  return "none";
}

std::vector<CharacteristicRow> characteristic_rows(const loads::Characteristics& values,
                                                   const double reference_speed) {
  Rows rows;
  rows.add("reference speed", reference_speed, Dimension::angular_speed);
  rows.add("maximum wheel speed over it", values.speed_ratio, Dimension::dimensionless);
  rows.add("maximum wheel acceleration over its square", values.acceleration_ratio,
           Dimension::dimensionless);
  rows.add("  at entry", values.entry_acceleration_ratio, Dimension::dimensionless);
  rows.add("wheel jerk over its cube, midway", values.jerk_ratio_at_centre,
           Dimension::dimensionless);
  rows.add("driver angle in engagement", values.engagement_angle, Dimension::angle);
  rows.add("motion time", values.motion_time, Dimension::time);
  for (const double time : values.dwell_times) rows.add("dwell time", time, Dimension::time);
  rows.add("motion time over the whole", values.motion_fraction, Dimension::dimensionless);
  rows.add("motion time over dwell time, k_t", values.time_ratio, Dimension::dimensionless);
  add_forces(rows, values);
  return rows.list();
}

json kinematics_summary(const KinematicsReport& report) {
  const loads::Characteristics& values = report.values;
  json result{{"case", case_section(report.about)},
              {"mechanism", report.mechanism},
              {"pin_type", report.is_roller ? "roller" : "fixed"},
              {"reference_speed", quantity(report.reference_speed, "rad/s")},
              {"versions", versions_section(report.geneva_version)}};
  result["peak_speed_ratio"] = values.speed_ratio.value;
  result["peak_acceleration_ratio"] = values.acceleration_ratio.value;
  result["peak_acceleration_angle"] = quantity(values.acceleration_ratio.driver_angle, "rad");
  result["entry_acceleration_ratio"] = finite(values.entry_acceleration_ratio);
  result["jerk_ratio_at_centre"] = finite(values.jerk_ratio_at_centre);
  result["engagement_angle"] = quantity(values.engagement_angle, "rad");
  result["motion_time"] = quantity(values.motion_time, "s");
  result["dwell_time"] = json::array();
  for (const double time : values.dwell_times) result["dwell_time"].push_back(quantity(time, "s"));
  result["motion_fraction"] = values.motion_fraction;
  result["time_ratio"] = finite(values.time_ratio);
  add_peak(result, "peak_force", values.force, "N");
  result["peak_force_ratio"] = finite(values.force_ratio);
  add_peak(result, "peak_braking_force", values.braking_force, "N");
  add_peak(result, "peak_hertz_pressure", values.pressure, "Pa");
  result["peak_hertz_pressure_ratio"] = finite(values.pressure_ratio);
  add_peak(result, "peak_pressure_times_slip", values.pressure_times_slip, "Pa m/s");
  result["peak_pressure_times_slip_ratio"] = finite(values.pressure_times_slip_ratio);
  add_peak(result, "peak_bore_pressure_times_speed", values.bore_pressure_times_speed, "Pa m/s");
  result["slip_reversals"] = reversals_section(values.slip_reversals);
  result["entry_tangency"] = quantity(values.entry_tangency, "rad");
  result["exit_tangency"] = quantity(values.exit_tangency, "rad");
  result["bounded"] = report.unbounded.empty();
  result["unbounded"] = unbounded_section(report.unbounded);
  result["characteristics"] = characteristics_section(report);
  return result;
}

std::string kinematics_csv(const KinematicsReport& report, const UnitSystem units) {
  const auto heading = [&](const char* name, const Dimension dimension) {
    return fmt::format("{} [{}]", name, output_unit(units, dimension).name);
  };
  std::string text = fmt::format(
      "{},{},speed_ratio,acceleration_ratio,jerk_ratio,{},{},{},{},wall,{},{},{},{},{},{},{}\n",
      heading("driver_angle", Dimension::angle), heading("wheel_angle", Dimension::angle),
      heading("pin_distance", Dimension::length), heading("slip_speed", Dimension::speed),
      heading("pin_force", Dimension::force), heading("hertz_pressure", Dimension::stress),
      heading("time", Dimension::time), heading("driver_speed", Dimension::angular_speed),
      heading("driver_acceleration", Dimension::angular_acceleration),
      heading("travel_speed", Dimension::speed), heading("slip_speed_driving", Dimension::speed),
      heading("slip_speed_braking", Dimension::speed), heading("bore_speed", Dimension::speed));
  const auto in = [&](const Dimension dimension) { return output_unit(units, dimension).factor; };
  const double omega = report.reference_speed;
  for (const KinematicsRow& row : report.rows) {
    const loads::Jet& wheel = row.motion.wheel_angle;
    text += fmt::format(
        "{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{},{:.12g},{:.12g}"
        ","
        "{:.12g},{:.12g},{:.12g},{:.12g},{:.12g}\n",
        row.load.driver_angle * in(Dimension::angle), wheel.value * in(Dimension::angle),
        wheel.first / omega, wheel.second / (omega * omega), wheel.third / (omega * omega * omega),
        row.load.pin_distance * in(Dimension::length), row.load.slip_speed * in(Dimension::speed),
        row.load.force * in(Dimension::force), row.pressure * in(Dimension::stress),
        name_of(row.load.wall), row.load.time * in(Dimension::time),
        row.load.driver_speed * in(Dimension::angular_speed),
        row.load.driver_acceleration * in(Dimension::angular_acceleration),
        row.load.travel_speed * in(Dimension::speed), row.load.slip_driving * in(Dimension::speed),
        row.load.slip_braking * in(Dimension::speed), row.load.bore_speed * in(Dimension::speed));
  }
  return text;
}

std::string kinematics_table(const KinematicsReport& report, const UnitSystem units) {
  std::string text = report.mechanism + "\n";
  for (const CharacteristicRow& row : characteristic_rows(report.values, report.reference_speed))
    text += line_of(row, units);
  const OutputUnit angle = output_unit(units, Dimension::angle);
  for (const loads::Unbounded& place : report.unbounded)
    text += fmt::format("not bounded: the {} at {:.6g} {}: {}\n", place.quantity,
                        place.driver_angle * angle.factor, angle.name, place.cause);
  return text;
}

}  // namespace geneva::post
