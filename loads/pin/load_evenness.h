#pragma once

#include <vector>

#include "loads/pin/pin_line.h"

namespace geneva::loads {

/// Part of the length over which a maximum line load is averaged.
constexpr double evenness_window = 0.05;

/// A place along a pin that carries a load.
struct LoadedPlace {
  double z;              ///< [m]
  double line_load;      ///< [N/m]
  double peak_pressure;  ///< [Pa]
};

/// How evenly a pin carries its load along its length. The maximum line load is the maximum mean
/// over a twentieth of the length: at a sharp edge the line load itself has no bound.
struct LoadEvenness {
  double maximum;        ///< [N/m]
  double place;          ///< middle of that twentieth along z [m]
  double even;           ///< pin force over the length on which the surfaces face each other [N/m]
  double peak_pressure;  ///< [Pa]
  double middle_pressure;             ///< [Pa]
  bool is_bounded;                    ///< the pressure at the ends
  std::vector<LoadedPlace> sections;  ///< by ascending z

  /// 1 for an even load.
  [[nodiscard]] double ratio() const { return maximum / even; }
};

/// Of line contacts along a pin.
LoadEvenness load_evenness(const PinLine& pin, const PinLineContact& contact);

}  // namespace geneva::loads
