#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "base/units.h"

namespace geneva::post {

/// A paragraph in large type: "peak contact pressure 177.84 MPa ± 0.16 %"; all three are HTML.
std::string answer(const std::string& name, const std::string& figure, const std::string& more);

/// "72 684 psi", a dash for null.
std::string shown_with_unit(const nlohmann::json& quantity, base::Dimension dimension,
                            base::UnitSystem units);

/// "at a driver angle of -11.464 deg"; empty for null.
std::string at_angle(const nlohmann::json& driver_angle, base::UnitSystem units);

/// The factor in a table's verdict: allowed from 1 on; not a number is exceeded.
std::string verdict_cell(double factor);

/// The limit that is nearest, in large type with its verdict; empty where there is none.
/// @param safety rows of a document's section `safety`
std::string nearest_limit(const nlohmann::json& safety, base::UnitSystem units);

/// Of a run: how near its limits are, as analysed and over the cycle; empty if the case gives none.
/// @param is_judged whether the error of the result is known, so that a verdict has a ground
std::string run_limits_table(const nlohmann::json& safety, base::UnitSystem units, bool is_judged);

/// Of everything else: the greatest values beside their limits; empty if the case gives none.
std::string limits_table(const nlohmann::json& safety, const std::string& caption,
                         base::UnitSystem units);

}  // namespace geneva::post
