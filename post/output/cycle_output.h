#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/json_values.h"
#include "base/units.h"
#include "loads/motion/cycle_instants.h"
#include "post/output/limit_rows.h"

namespace geneva::post {

/// A maximum stress of a body away from the contact.
struct CycleStress {
  std::string body;
  std::string name;             ///< "von Mises stress" or "tensile stress"
  double value;                 ///< [Pa]
  double error;                 ///< relative
  std::string where;            ///< in words
  std::array<double, 3> place;  ///< in the frame of the engaged slot, whose axis is x [m]
  unsigned int body_index;      ///< in the order of the coarse mesh's bodies
};

/// The contact as finite elements find it at one instant, SI units.
struct CycleContact {
  double peak_pressure;               ///< [Pa]
  double error;                       ///< of that, estimated, relative
  double half_width;                  ///< [m]
  std::optional<double> bore_torque;  ///< [N m]; none of a block
  double expected_bore_torque;        ///< J_L a + M_f + M_e [N m]
  std::vector<CycleStress> stresses;
  std::string hertz_objection;  ///< why Hertz's pressure is no reference here; may be empty
  std::string shortfall;        ///< what was reached instead of the accuracy, and why; may be empty
  double seconds;               ///< that it took
};

/// What a material point is under along one direction while the cycle goes round.
struct Swing {
  std::string body;
  double least = 0.;                   ///< [Pa], <= 0: nothing acts between engagements
  std::optional<double> driver_angle;  ///< of that [rad]; none: between engagements

  template <class Archive>
  void serialize(Archive& archive, const unsigned int /*version*/) {
    bool is_at_instant = driver_angle.has_value();
    double angle = driver_angle.value_or(0.);
    archive& body& least& is_at_instant& angle;
    driver_angle = is_at_instant ? std::optional(angle) : std::nullopt;
  }
};

/// An instant of the cycle, SI units.
struct CyclePoint {
  loads::CycleInstant instant;
  double hertz_pressure;                ///< [Pa]
  std::optional<CycleContact> contact;  ///< none where it could not be solved
  std::string refusal;                  ///< why there is none
};

/// Force and pressure between the instants.
struct CycleCurvePoint {
  double driver_angle;    ///< [rad]
  double force;           ///< [N]; negative: on the braking wall
  double hertz_pressure;  ///< [Pa]
  double peak_pressure;   ///< Hertz's times what the instants around have of it [Pa]
  double slip_speed;      ///< on the wall that carries [m/s]
  double pin_distance;    ///< where the pin touches the wall, from the wheel's axis [m]
  double pin_turn;        ///< psi [rad] of the pin's carrier, see loads::SlotMotion
  /// Heat of friction that the pass leaves per area of wall and of pin: mu F/t |v_s/u'| and mu F/t
  /// |v_s|/(d/2 |psi'|) [J/m^2]; not a number where that point stands still, 0 without friction.
  double wall_heat;
  double pin_heat;
};

/// What one engagement does, by quadrature over the motion, SI units.
struct CycleWork {
  double pin;            ///< of the pin on the wheel [J]
  double energy_change;  ///< of wheel and load, with what friction and external torque take [J]
  double driving;        ///< of the pin while it drives the wheel [J]
  double friction;       ///< heat of the slot's friction [J]
};

/// A cycle of the mechanism by finite elements.
struct CycleReport {
  base::CaseHeader about;
  std::string geneva_version;
  std::string mechanism;  ///< in words
  double accuracy;        ///< wanted of each instant, relative
  std::vector<CyclePoint> points;
  std::vector<CycleCurvePoint> curve;
  std::vector<double> wall_changes;  ///< driver angles [rad]
  std::size_t left_out;              ///< engagements like the first one
  CycleWork work;                    ///< of the first engagement
  std::vector<Swing> swings;  ///< of each body that has a tensile stress, where it is greatest
  std::vector<LimitRow> limits;
  std::vector<std::string> notices;
  double seconds;
  unsigned int ranks;
};

/// The greatest peak pressure of the instants; none if none was solved.
const CyclePoint* greatest_pressure(const CycleReport& report);

/// A maximum stress over the cycle.
struct CycleStressRange {
  CycleStress greatest;
  double driver_angle;         ///< of that [rad]
  std::optional<Swing> swing;  ///< of a tensile stress: along its direction, at its material point

  /// From the least to the greatest [Pa]; of a von Mises stress from 0.
  [[nodiscard]] double range() const { return greatest.value - (swing ? swing->least : 0.); }
};

/// Of every body and stress that the instants have.
std::vector<CycleStressRange> stress_ranges(const CycleReport& report);

/// "-9.934 deg, driving wall, greatest force"
std::string instant_in_words(const loads::CycleInstant& instant);

/// What was found of a point, as text from which take_over() makes it again on another rank.
std::string solved_text(const CyclePoint& point);
void take_over(CyclePoint& point, const std::string& solved);

/// What cycle.json says, SI units throughout.
nlohmann::json cycle_summary(const CycleReport& report);

/// What cycle.csv says: a line for each instant, the units in the headings.
std::string cycle_csv(const CycleReport& report, base::UnitSystem units);

/// What cycle_curve.csv says: force, pressure, slip and heat between the instants.
std::string cycle_curve_csv(const CycleReport& report, base::UnitSystem units);

/// The instants and what is greatest, as lines.
std::string cycle_table(const CycleReport& report, base::UnitSystem units);

}  // namespace geneva::post
