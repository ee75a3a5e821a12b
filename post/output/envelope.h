#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "post/output/cycle_fields.h"
#include "post/output/cycle_output.h"

namespace geneva::post {

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

/// Where the pin is, see CycleFields.
struct PinPosition {
  double distance;  ///< [m]
  double turn;      ///< [rad]
};

/// The envelope at nodes that stand as at an instant, from the fields of all instants at the same
/// material points, interpolated where the mesh is another one: the wheel stands still, the pin
/// moves along the slot and turns.
class EnvelopeOfNodes {
 public:
  /// @param own instant whose nodes they are; must outlive it
  /// @param turning bodies that move with the pin, by the index of the coarse mesh's bodies
  /// @param nodes of that instant, quickest if neighbours follow each other
  EnvelopeOfNodes(const CycleFields& own, std::vector<bool> turning,
                  std::vector<std::size_t> nodes);

  /// Instants in the order of the motion: of equal values the first one counts.
  void add(const CycleFields& instant);

  /// At these nodes, in their order.
  Envelope result() &&;

 private:
  /// What a node is under at an instant.
  struct NodeStress {
    std::array<double, 6> stress;  ///< [Pa]
    NodeMaxima maxima;
  };
  using NodesUnder = std::vector<NodeStress>;

  /// Least stress along the direction in which the greatest tension of a node acts, at most 0.
  /// @param i place of the node among the nodes
  [[nodiscard]] double least_tension(std::size_t i, bool turns) const;

  const CycleFields& own_;
  std::vector<bool> turning_;
  std::vector<unsigned int> bodies_;  ///< of all nodes
  std::vector<std::size_t> nodes_;
  Envelope greatest_;
  std::vector<PinPosition> positions_;  ///< by instant
  std::vector<NodesUnder> stresses_;    ///< by instant and place of the node
};

/// That of all nodes and instants.
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

}  // namespace geneva::post
