#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/json_values.h"
#include "base/units.h"
#include "loads/hertz.h"
#include "loads/motion/pin_load.h"
#include "loads/pin/pin_line.h"
#include "post/output/limit_rows.h"

namespace geneva::post {

/// One figure of an estimate and what it comes from; SI units.
struct EstimateRow {
  std::string quantity;
  base::Dimension dimension;
  double value;
  std::string basis;
};

/// An angle of the driver at which the pin presses on a wall; SI units.
struct EngagementPoint {
  double driver_angle;                  ///< [rad]
  double force;                         ///< [N]; negative: on the braking wall
  double even_pressure;                 ///< Hertz's of an even load [Pa]
  std::optional<double> peak_pressure;  ///< in 3-D, where line contacts know it [Pa]
};

/// What closed forms and the pin's line contacts say of a case, SI units.
struct EstimateReport {
  base::CaseHeader about;
  std::string geneva_version;
  std::string mechanism;  ///< in words
  loads::PinLoad load;
  double relative_radius;                           ///< R [m]
  double contact_modulus;                           ///< E* [Pa]
  double poissons_ratio;                            ///< the smaller one of pin and wheel
  double even_line_load;                            ///< F/t [N/m]
  loads::HertzLine even;                            ///< Hertz's contact of that
  std::optional<loads::PinLineContact> line;        ///< in 3-D
  loads::PeakDoubt doubt = loads::PeakDoubt::none;  ///< of that
  double wheel_twist = 0.;                          ///< of that, see loads::PinLine
  std::optional<double> expected_error;             ///< of its peak, relative; none without one
  std::vector<EngagementPoint> engagement;
  std::vector<EstimateRow> rows;
  std::vector<LimitRow> limits;       ///< of the greatest pressure of the engagement
  std::vector<std::string> left_out;  ///< sentences
};

/// What estimate.json says, SI units throughout.
nlohmann::json estimate_summary(const EstimateReport& report);

/// What estimate.csv says: line load, pressure and half-width along the pin, in the plane Hertz's
/// stresses below the middle of the contact; the units in the headings.
std::string estimate_csv(const EstimateReport& report, base::UnitSystem units);

/// Table of the figures, the units in the rows' names, and what is left out.
std::string estimate_table(const EstimateReport& report, base::UnitSystem units);

}  // namespace geneva::post
