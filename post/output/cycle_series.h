#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/units.h"
#include "post/output/cycle_fields.h"
#include "post/output/envelope.h"

namespace geneva::post {

/// What tells the instants of a series apart.
struct SeriesOrder {
  std::string name;      ///< "driver_angle"
  double factor;         ///< from CycleFields::when to its output unit
  std::string files;     ///< beginning of the files' names
  std::string envelope;  ///< file of the envelope
};

/// Files of a series, as texts by their names: "cycle.pvd", "cycle.N.vtu" for every instant, and
/// the envelope.
/// @param own nodes of the envelope
/// @param pressure at these nodes; none: not known
std::map<std::string, std::string> cycle_series(const std::vector<CycleFields>& instants,
                                                const NodalFields& own, const Envelope& greatest,
                                                const SeriesOrder& order,
                                                const std::optional<PressureEnvelope>& pressure,
                                                base::UnitSystem units);

}  // namespace geneva::post
