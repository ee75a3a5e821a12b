#pragma once

#include <map>
#include <optional>
#include <string>

#include "loads/contact_limits.h"

namespace geneva::loads {

/// What the case allows.
struct Allowables {
  std::optional<double> contact_pressure;           ///< [Pa]
  std::optional<double> pressure_times_slip;        ///< contact pressure times slip speed [Pa m/s]
  std::map<std::string, double> yield_strengths;    ///< [Pa] by body
  std::map<std::string, double> fatigue_strengths;  ///< under pulsating tension [Pa] by body
  std::map<std::string, double> flank_pressures;    ///< of contact, of the body's material [Pa]
  std::map<std::string, HardenedLayer> layers;      ///< of bodies whose surface is hardened
};

}  // namespace geneva::loads
