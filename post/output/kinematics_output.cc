#include "post/output/kinematics_output.h"

#include <fmt/format.h>

#include <algorithm>
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

/// A quantity of the table with its symbol and what it means.
struct Quantity {
  std::string name;
  const char* symbol;
  const char* meaning;
};

/// Builds the rows.
class Rows {
 public:
  void add(const Quantity& quantity, const double value, const Dimension dimension) {
    list_.push_back(
        {quantity.name, quantity.symbol, quantity.meaning, dimension, value, std::nullopt});
  }
  void add(const Quantity& quantity, const PlacedPeak& peak, const Dimension dimension) {
    add(quantity, peak.value, dimension);
    if (peak.value > 0.) list_.back().driver_angle = peak.driver_angle;
  }
  void add_if_finite(const Quantity& quantity, const double value) {
    if (std::isfinite(value)) add(quantity, value, Dimension::dimensionless);
  }
  [[nodiscard]] const std::vector<CharacteristicRow>& list() const { return list_; }

 private:
  std::vector<CharacteristicRow> list_;
};

void add_motion(Rows& rows, const loads::Characteristics& values, const double reference_speed) {
  constexpr Dimension ratio = Dimension::dimensionless;
  rows.add({"reference speed", "ω", "speed of the driver to which the ratios below refer"},
           reference_speed, Dimension::angular_speed);
  rows.add({"maximum wheel speed over it", "φ′", "first derivative of the wheel angle, by θ"},
           values.speed_ratio, ratio);
  rows.add({"maximum wheel acceleration over its square", "φ″",
            "second derivative of the wheel angle, by θ: Johnson's point"},
           values.acceleration_ratio, ratio);
  rows.add(
      {"  at entry", "φ″(θ₀)", "by which the acceleration jumps where the pin enters its slot"},
      values.entry_acceleration_ratio, ratio);
  rows.add({"wheel jerk over its cube, midway", "φ‴(0)",
            "third derivative of the wheel angle, by θ, on the line of centres"},
           values.jerk_ratio_at_centre, ratio);
  rows.add({"maximum wheel jerk over its cube", "|φ‴|",
            "greatest size of the third derivative of the wheel angle, by θ"},
           values.jerk_ratio, ratio);
  rows.add({"driver angle in engagement", "Δθ", "turn of the driver from entry to exit"},
           values.engagement_angle, Dimension::angle);
  rows.add({"motion time", "t_m", "time in which a pin is in its slot"}, values.motion_time,
           Dimension::time);
  const bool are_equal = std::all_of(
      values.dwell_times.begin(), values.dwell_times.end(),
      [&](const double time) { return std::abs(time - values.dwell_times.front()) < 1e-9 * time; });
  const std::size_t n_dwells =
      are_equal ? std::min<std::size_t>(1, values.dwell_times.size()) : values.dwell_times.size();
  for (std::size_t i = 0; i < n_dwells; ++i)
    rows.add({are_equal ? "dwell time" : fmt::format("dwell time after engagement {}", i + 1),
              "t_s", "time in which the wheel rests, for the work at the station"},
             values.dwell_times[i], Dimension::time);
  rows.add({"motion time over the whole", "t_m/(t_m + t_s)", "share of the cycle in motion"},
           values.motion_fraction, ratio);
  rows.add(
      {"motion time over dwell time, k_t", "k_t", "small: much time for the work at the station"},
      values.time_ratio, ratio);
}

void add_forces(Rows& rows, const loads::Characteristics& values) {
  const Quantity over_johnson{"  over that at the maximum acceleration", "",
                              "how much inertia alone, at Johnson's point, underrates it"};
  rows.add({"maximum pin force", "F", "of the pin on the driving wall"}, values.force,
           Dimension::force);
  rows.add_if_finite(over_johnson, values.force_ratio);
  if (values.braking_force.value > 0.)
    rows.add({"maximum force on the braking wall", "F_b",
              "of the pin on the wall behind it, while it slows the wheel down"},
             values.braking_force, Dimension::force);
  rows.add({"maximum Hertz pressure", "p₀", "peak contact pressure of the closed form"},
           values.pressure, Dimension::stress);
  rows.add_if_finite(over_johnson, values.pressure_ratio);
  rows.add({"maximum pressure x slip", "p₀ v_s",
            "peak pressure times the speed at which the pin's surface slides: wear and heat"},
           values.pressure_times_slip, Dimension::pressure_times_speed);
  rows.add_if_finite(over_johnson, values.pressure_times_slip_ratio);
  if (values.slip_speed.value > 0.)
    rows.add({"maximum slip speed", "v_s", "of the pin's surface on the wall that carries"},
             values.slip_speed, Dimension::speed);
  if (values.bore_pressure_times_speed.value > 0.)
    rows.add({"maximum mean bore pressure x sliding speed", "p v",
              "F/(d_b t) times the speed of the roller on its stud, as bearings are chosen"},
             values.bore_pressure_times_speed, Dimension::pressure_times_speed);
  for (const loads::SlipReversal& reversal : values.slip_reversals)
    rows.add({fmt::format("slip reverses on the {} wall at", name_of(reversal.wall)), "θ_r",
              "driver angle at which the pin's surface rolls without slip"},
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
                    {"symbol", row.symbol},
                    {"meaning", row.meaning},
                    {"dimension", name_of(row.dimension)},
                    {"value", quantity(row.value, row.dimension)},
                    {"driver_angle",
                     row.driver_angle ? quantity(*row.driver_angle, Dimension::angle) : json()}});
  return list;
}

json choice_section(const std::vector<PinChoiceRow>& rows) {
  json list = json::array();
  for (const PinChoiceRow& row : rows)
    list.push_back({{"quantity", row.quantity},
                    {"dimension", name_of(row.dimension)},
                    {"roller", quantity(row.roller, row.dimension)},
                    {"fixed", row.fixed ? quantity(*row.fixed, row.dimension) : json()}});
  return list;
}

std::string choice_table(const std::vector<PinChoiceRow>& rows, const UnitSystem units) {
  if (rows.empty()) return "";
  std::string text = fmt::format("{:<52} {:>12} {:>12}\n", "", "roller", "fixed pin");
  for (const PinChoiceRow& row : rows) {
    const OutputUnit unit = output_unit(units, row.dimension);
    const auto cell = [&](const std::optional<double>& value) {
      return value ? fmt::format("{:.6g}", shown(*value) * unit.factor) : std::string("-");
    };
    text += fmt::format(
        "{:<52} {:>12} {:>12}\n",
        unit.name.empty() ? row.quantity : fmt::format("{} [{}]", row.quantity, unit.name),
        cell(row.roller), cell(row.fixed));
  }
  return text;
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
  add_motion(rows, values, reference_speed);
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
  result["safety"] = limits_section(report.limits);
  result["peak_speed_ratio"] = values.speed_ratio.value;
  result["peak_acceleration_ratio"] = values.acceleration_ratio.value;
  result["peak_acceleration_angle"] = quantity(values.acceleration_ratio.driver_angle, "rad");
  result["entry_acceleration_ratio"] = finite(values.entry_acceleration_ratio);
  result["jerk_ratio_at_centre"] = finite(values.jerk_ratio_at_centre);
  result["peak_jerk_ratio"] = finite(values.jerk_ratio.value);
  result["peak_jerk_angle"] = quantity(values.jerk_ratio.driver_angle, "rad");
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
  add_peak(result, "peak_slip_speed", values.slip_speed, "m/s");
  add_peak(result, "peak_bore_pressure_times_speed", values.bore_pressure_times_speed, "Pa m/s");
  result["slip_reversals"] = reversals_section(values.slip_reversals);
  result["entry_tangency"] = quantity(values.entry_tangency, "rad");
  result["exit_tangency"] = quantity(values.exit_tangency, "rad");
  result["bounded"] = report.unbounded.empty();
  result["unbounded"] = unbounded_section(report.unbounded);
  result["characteristics"] = characteristics_section(report);
  if (!report.choice.empty()) result["roller_or_fixed_pin"] = choice_section(report.choice);
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
  text += choice_table(report.choice, units) + limit_lines(report.limits, units);
  const OutputUnit angle = output_unit(units, Dimension::angle);
  for (const loads::Unbounded& place : report.unbounded)
    text += fmt::format("not bounded: the {} at {:.6g} {}: {}\n", place.quantity,
                        place.driver_angle * angle.factor, angle.name, place.cause);
  return text;
}

}  // namespace geneva::post
