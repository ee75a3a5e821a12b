#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "loads/motion/pin_load.h"
#include "post/results.h"
#include "post/units.h"

namespace geneva::post {

/// What the mechanism asks of the contact, SI units.
struct MechanismReport {
  loads::PinLoad load;
  std::optional<double> inertia_from_geometry;  ///< [kg m^2]; none unless a wheel is drawn
  double inertia_used;                          ///< [kg m^2]
  double expected_bore_torque;                  ///< J_L a + M_f + M_e [N m]
  std::string held_surface;           ///< of the wheel: "bore" or "rim"; of a block: "back"
  std::optional<double> bore_torque;  ///< from the computed reactions [N m]; none with a block
};

/// What a run is about and what it cost.
struct RunReport {
  std::string case_name;
  std::string title;
  std::optional<MechanismReport> mechanism;
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

/// The machine-readable summary, always in SI units; doc/results.md lists the keys.
nlohmann::json summary(const fem::Solution<2>& solution, const Results& results,
                       const RunReport& report);

/// The table that ends a run: this program, closed form, published value, difference.
std::string comparison_table(const fem::Solution<2>& solution, const Results& results,
                             const RunReport& report, UnitSystem units);

}  // namespace geneva::post
