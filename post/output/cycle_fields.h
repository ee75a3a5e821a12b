#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/units.h"
#include "post/output/cycle_output.h"
#include "post/output/nodal_fields.h"

namespace geneva::post {

/// The fields of one instant, of a mechanism in the frame of the engaged slot, whose axis is x; SI
/// units.
struct CycleFields {
  double when;          ///< driver angle [rad], without a mechanism the number of the load step
  double pin_distance;  ///< of the pin's axis from the wheel's [m]
  double pin_turn;      ///< psi [rad] of a pin fixed to its carrier, clockwise; see SlotMotion
  NodalFields fields;

  template <class Archive>
  void serialize(Archive& archive, const unsigned int /*version*/) {
    archive& when& pin_distance& pin_turn& fields;
  }
};

/// The greatest values of the instants at every node of one of them.
struct Envelope {
  std::vector<double> von_mises;             ///< [Pa]
  std::vector<double> von_mises_when;        ///< see CycleFields
  std::vector<double> first_principal;       ///< [Pa]
  std::vector<double> first_principal_when;  ///< see CycleFields
  std::vector<double> max_shear;             ///< (s1 - s3)/2 [Pa]
  std::vector<double> max_shear_when;        ///< see CycleFields
  /// Least along the direction of the greatest first principal stress, and 0 between engagements.
  std::vector<double> tension_least;
};

/// Maxima of a node's stress [Pa].
struct NodeMaxima {
  double von_mises;
  double first_principal;
  double max_shear;  ///< (s1 - s3)/2
};

/// Raises the envelope at a node to what is greater there.
void raise(Envelope& envelope, std::size_t node, const NodeMaxima& stress, double when);

/// At nodes that stand as at an instant, from the fields of all instants at the same material
/// points, interpolated where the mesh is another one: the wheel stands still, the pin moves along
/// the slot and turns.
/// @param own those nodes
/// @param turning bodies that move with the pin, by the index of the coarse mesh's bodies
Envelope envelope(const CycleFields& own, const std::vector<CycleFields>& instants,
                  const std::vector<bool>& turning);

/// Over the instants and between engagements, along the direction of a tensile stress of one of
/// them and at its material point, as envelope() follows it.
/// @param at index of that instant
Swing swing_of(const CycleStress& tensile, const std::vector<CycleFields>& instants, std::size_t at,
               const std::vector<bool>& turning);

/// The greatest contact pressure at the nodes of an instant.
struct PressureEnvelope {
  std::vector<double> pressure;  ///< [Pa]; 0 where none passes
  std::vector<double> when;      ///< see CycleFields
};

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
