#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/units.h"
#include "post/output/cycle_output.h"
#include "post/output/nodal_fields.h"

namespace geneva::post {

/// The fields of one instant in the frame of the engaged slot, whose axis is x; SI units.
struct CycleFields {
  double driver_angle;  ///< [rad]
  double pin_distance;  ///< of the pin's axis from the wheel's [m]
  double pin_turn;      ///< psi [rad] of a pin fixed to its carrier, clockwise; see SlotMotion
  NodalFields fields;

  template <class Archive>
  void serialize(Archive& archive, const unsigned int /*version*/) {
    archive& driver_angle& pin_distance& pin_turn& fields;
  }
};

/// The greatest values of the instants at every node of one of them.
struct Envelope {
  std::vector<double> von_mises;              ///< [Pa]
  std::vector<double> von_mises_angle;        ///< driver angle of it [rad]
  std::vector<double> first_principal;        ///< [Pa]
  std::vector<double> first_principal_angle;  ///< [rad]
  std::vector<double> max_shear;              ///< (s1 - s3)/2 [Pa]
  std::vector<double> max_shear_angle;        ///< [rad]
  /// Least along the direction of the greatest first principal stress, and 0 between engagements.
  std::vector<double> tension_least;
};

/// At the nodes of an instant, from the fields of all, interpolated at the same material points:
/// the wheel stands still, the pin moves along the slot and turns.
/// @param at index of the instant whose nodes they are
/// @param turning bodies that move with the pin, by the index of the coarse mesh's bodies
Envelope envelope(const std::vector<CycleFields>& instants, std::size_t at,
                  const std::vector<bool>& turning);

/// Over the instants and between engagements, along the direction of a tensile stress of one of
/// them and at its material point, as envelope() follows it.
/// @param at index of that instant
Swing swing_of(const CycleStress& tensile, const std::vector<CycleFields>& instants, std::size_t at,
               const std::vector<bool>& turning);

/// cycle.pvd, cycle.N.vtu for every instant, and envelope.vtu, as texts by their names.
/// @param at, turning as envelope() takes them
/// @param curve of a cycle in the plane, for the contact pressure of the envelope; may be empty
std::map<std::string, std::string> cycle_series(const std::vector<CycleFields>& instants,
                                                std::size_t at, const std::vector<bool>& turning,
                                                const std::vector<CycleCurvePoint>& curve,
                                                base::UnitSystem units);

}  // namespace geneva::post
