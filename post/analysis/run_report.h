#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/json_values.h"
#include "base/units.h"
#include "loads/allowables.h"
#include "loads/motion/kinematics.h"
#include "loads/pin/pin_beam.h"
#include "loads/pin/pin_line.h"
#include "post/analysis/figures.h"
#include "post/analysis/pin_bending.h"

namespace geneva::post {

/// The pin as line contacts that half-spaces and a beam couple.
struct PinLineReport {
  loads::PinLine pin;
  loads::PinLineContact contact;
  loads::PeakDoubt doubt;  ///< of the contact's peak
};

/// The pin of a mechanism in 3-D.
struct PinReport {
  PinBending bending;
  std::optional<PinLineReport> line;  ///< none if line contacts know no answer
  std::string profile;                ///< as the case names it
  double amplitude;                   ///< of a logarithmic profile [m]; 0: other ones
  double crown_radius;                ///< [m]; 0: other ones
};

/// The most loaded needle of a roller's bearing.
struct NeedleReport {
  double load;      ///< [N]
  double pressure;  ///< on the stud, by Hertz [Pa]
};

/// What the mechanism asks of the contact, SI units.
struct MechanismReport {
  loads::PinLoad load;
  std::optional<double> inertia_from_geometry;  ///< [kg m^2]; none unless a wheel is drawn
  double inertia_used;                          ///< [kg m^2]
  double expected_bore_torque;                  ///< J_L a + M_f + M_e [N m]
  std::string held_surface;                ///< of the wheel: "bore" or "rim"; of a block: "back"
  std::optional<double> bore_torque;       ///< from the computed reactions [N m]; none with a block
  std::optional<loads::BeamBending> beam;  ///< of the pin; none if it is held at its core
  std::optional<PinReport> pin;            ///< in 3-D
  double parts;                            ///< of which the model is one: 2 of a half model
  std::optional<loads::RollerBore> roller;  ///< none: the pin is fixed to its carrier
  double bore_pressure;  ///< mean, of a roller at the analysed angle [Pa]; 0 of a fixed pin
                         ///< and of a roller on needles
  std::optional<NeedleReport> needle;  ///< of a roller on needles, at the analysed angle
  double slot_friction;                ///< coefficient, of a pin fixed to its carrier
  loads::PlacedPeak cycle_force;       ///< maximum pin force of the cycle [N]
  /// Maximum pressure of the cycle: Hertz's, in 3-D the computed one as line contacts scale it
  /// where they know it [Pa]
  loads::PlacedPeak cycle_pressure;
  loads::PlacedPeak cycle_wear;  ///< maximum pressure times sliding speed of the cycle: Hertz's on
                                 ///< the wall, or a roller's mean pressure in its bore [Pa m/s]
};

/// What a run is about and what it cost.
struct RunReport {
  base::CaseHeader about;
  double accuracy;                   ///< wanted, relative
  std::vector<std::string> notices;  ///< what the user should know before trusting the figures
  std::string stop_message;          ///< why the refinement ended early; empty if it converged
  std::optional<MechanismReport> mechanism;
  RunFigures errors;  ///< estimated, relative
  loads::Allowables allowed;
  std::optional<double> published_peak_pressure;  ///< [Pa]
  std::string published_source;
  double mesh_seconds;
  double solve_seconds;
  double post_seconds;
  double total_seconds;
  double peak_memory;  ///< resident, all ranks [bytes]
  unsigned int ranks;
  std::string geneva_version;
  std::string gmsh_version;
};

}  // namespace geneva::post
