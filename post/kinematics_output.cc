#include "post/kinematics_output.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "post/json_values.h"

namespace geneva::post {

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

/// What is 0 all the way has no place.
void add_peak(json& result, const std::string& name, const PlacedPeak& peak, const char* unit) {
  result[name] = quantity(peak.value, unit);
  result[name + "_angle"] = peak.value > 0. ? quantity(peak.driver_angle, "rad") : json(nullptr);
}

/// Lines of the table: name and value.
class Table {
 public:
  explicit Table(const UnitSystem units) : units_(units) {}

  void add(const std::string& name, const double value, const Dimension dimension) {
    const OutputUnit unit = output_unit(units_, dimension);
    line(unit.name.empty() ? name : fmt::format("{} [{}]", name, unit.name),
         fmt::format("{:.6g}", shown(value) * unit.factor));
  }
  void add(const std::string& name, const PlacedPeak& peak, const Dimension dimension) {
    add(name, peak, output_unit(units_, dimension));
  }
  /// A value whose unit is the product of two.
  void add(const std::string& name, const PlacedPeak& peak, const Dimension first,
           const Dimension second) {
    const OutputUnit a = output_unit(units_, first);
    const OutputUnit b = output_unit(units_, second);
    add(name, peak, {a.name + " " + b.name, a.factor * b.factor});
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void add(const std::string& name, const PlacedPeak& peak, const OutputUnit& unit) {
    const OutputUnit angle = output_unit(units_, Dimension::angle);
    line(unit.name.empty() ? name : fmt::format("{} [{}]", name, unit.name),
         fmt::format("{:.6g}", peak.value * unit.factor),
         peak.value > 0.
             ? fmt::format("at {:.5g} {}", shown(peak.driver_angle) * angle.factor, angle.name)
             : "");
  }
  void line(const std::string& name, const std::string& value, const std::string& place = "") {
    text_ += fmt::format("{:<52} {:>12}{}{}\n", name, value, place.empty() ? "" : "  ", place);
  }

  UnitSystem units_;
  std::string text_;
};

void add_forces(Table& table, const loads::Characteristics& values) {
  table.add("greatest pin force", values.force, Dimension::force);
  if (std::isfinite(values.force_ratio))
    table.add("  over that at the greatest acceleration", values.force_ratio,
              Dimension::dimensionless);
  if (values.braking_force.value > 0.)
    table.add("greatest force on the braking wall", values.braking_force, Dimension::force);
  table.add("greatest Hertz pressure", values.pressure, Dimension::stress);
  if (std::isfinite(values.pressure_ratio))
    table.add("  over that at the greatest acceleration", values.pressure_ratio,
              Dimension::dimensionless);
  table.add("greatest pressure x slip", values.pressure_times_slip, Dimension::stress,
            Dimension::speed);
  if (std::isfinite(values.pressure_times_slip_ratio))
    table.add("  over that at the greatest acceleration", values.pressure_times_slip_ratio,
              Dimension::dimensionless);
}

}  // namespace

json kinematics_summary(const KinematicsReport& report) {
  const loads::Characteristics& values = report.values;
  json result{{"case", report.case_name},
              {"title", report.title},
              {"mechanism", report.mechanism},
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
  result["entry_tangency"] = quantity(values.entry_tangency, "rad");
  result["exit_tangency"] = quantity(values.exit_tangency, "rad");
  result["bounded"] = report.unbounded.empty();
  result["unbounded"] = unbounded_section(report.unbounded);
  return result;
}

std::string kinematics_csv(const KinematicsReport& report, const UnitSystem units) {
  const auto heading = [&](const char* name, const Dimension dimension) {
    return fmt::format("{} [{}]", name, output_unit(units, dimension).name);
  };
  std::string text = fmt::format(
      "{},{},speed_ratio,acceleration_ratio,jerk_ratio,{},{},{},{},wall,{},{},{}\n",
      heading("driver_angle", Dimension::angle), heading("wheel_angle", Dimension::angle),
      heading("pin_distance", Dimension::length), heading("slip_speed", Dimension::speed),
      heading("pin_force", Dimension::force), heading("hertz_pressure", Dimension::stress),
      heading("time", Dimension::time), heading("driver_speed", Dimension::angular_speed),
      heading("driver_acceleration", Dimension::angular_acceleration));
  const auto in = [&](const Dimension dimension) { return output_unit(units, dimension).factor; };
  const double omega = report.reference_speed;
  for (const KinematicsRow& row : report.rows) {
    const loads::Jet& wheel = row.motion.wheel_angle;
    text += fmt::format(
        "{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{},{:.12g},{:.12g}"
        ","
        "{:.12g}\n",
        row.load.driver_angle * in(Dimension::angle), wheel.value * in(Dimension::angle),
        wheel.first / omega, wheel.second / (omega * omega), wheel.third / (omega * omega * omega),
        row.load.pin_distance * in(Dimension::length), row.load.slip_speed * in(Dimension::speed),
        row.load.force * in(Dimension::force), row.pressure * in(Dimension::stress),
        name_of(row.load.wall), row.load.time * in(Dimension::time),
        row.load.driver_speed * in(Dimension::angular_speed),
        row.load.driver_acceleration * in(Dimension::angular_acceleration));
  }
  return text;
}

std::string kinematics_table(const KinematicsReport& report, const UnitSystem units) {
  const loads::Characteristics& values = report.values;
  Table table(units);
  table.add("reference speed", report.reference_speed, Dimension::angular_speed);
  table.add("greatest wheel speed over it", values.speed_ratio, Dimension::dimensionless);
  table.add("greatest wheel acceleration over its square", values.acceleration_ratio,
            Dimension::dimensionless);
  table.add("  at entry", values.entry_acceleration_ratio, Dimension::dimensionless);
  table.add("wheel jerk over its cube, midway", values.jerk_ratio_at_centre,
            Dimension::dimensionless);
  table.add("driver angle in engagement", values.engagement_angle, Dimension::angle);
  table.add("motion time", values.motion_time, Dimension::time);
  for (const double time : values.dwell_times) table.add("dwell time", time, Dimension::time);
  table.add("motion time over the whole", values.motion_fraction, Dimension::dimensionless);
  table.add("motion time over dwell time, k_t", values.time_ratio, Dimension::dimensionless);
  add_forces(table, values);
  std::string text = report.mechanism + "\n" + table.text();
  const OutputUnit angle = output_unit(units, Dimension::angle);
  for (const loads::Unbounded& place : report.unbounded)
    text += fmt::format("not bounded: the {} at {:.6g} {}: {}\n", place.quantity,
                        place.driver_angle * angle.factor, angle.name, place.cause);
  return text;
}

}  // namespace geneva::post
