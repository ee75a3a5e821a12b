#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "fem/contact/node_status.h"
#include "fem/problem/problem.h"

namespace geneva::fem {

/// What is known of one node in contact, in the directions of its frame: normal, then tangents; in
/// the units of the triangulation.
template <int dim>
struct NodeContact {
  NodeStatus status;
  Components<dim> gap;       ///< > 0 when open, then the slip of the source since the last instant
  Components<dim> traction;  ///< on the source: pressure, >= 0 in compression, then friction
  /// Unit vector along the tangents in which the source slides on the target; 0 if it does not, or
  /// where that is not known.
  Components<dim> sliding{};
};

/// Gaps and pressures that are not told from 0.
struct ContactRounding {
  double gap;
  double pressure;
};

/// Conditions of contact at one node, in equations that are linear as long as its status stays:
/// residual + by_gap d(gap) + by_traction d(traction) = 0. An equation without by_traction is a
/// constraint; one without by_gap binds the traction of its direction, with a coefficient of 1, to
/// those of constraints.
template <int dim>
struct ContactEquations {
  using Matrix = std::array<Components<dim>, static_cast<std::size_t>(dim)>;
  Components<dim> residual{};
  Matrix by_gap{};
  Matrix by_traction{};
};

/// What happens where two surfaces meet.
template <int dim>
class ContactLaw {
 public:
  ContactLaw() = default;
  ContactLaw(const ContactLaw&) = delete;
  ContactLaw& operator=(const ContactLaw&) = delete;
  virtual ~ContactLaw() = default;

  /// The status that the node takes next, of a primal-dual active set method: a semismooth Newton
  /// step (Hintermueller, Ito and Kunisch 2003; Hueber, Stadler and Wohlmuth 2008).
  [[nodiscard]] virtual NodeStatus next_status(const NodeContact<dim>& node,
                                               const ContactRounding& rounding) const = 0;

  /// The direction in which a node that slips slides from now on, as NodeContact::sliding.
  [[nodiscard]] virtual Components<dim> next_sliding(const NodeContact<dim>& node) const {
    return node.sliding;
  }

  /// The status of a node that begins to touch.
  [[nodiscard]] virtual NodeStatus touching() const { return NodeStatus::slip; }

  /// The equations of the node's status.
  [[nodiscard]] virtual ContactEquations<dim> equations(const NodeContact<dim>& node) const = 0;
};

/// No traction along the surfaces: gap >= 0, pressure >= 0, and one of them is 0.
template <int dim>
class Frictionless : public ContactLaw<dim> {
 public:
  [[nodiscard]] NodeStatus next_status(const NodeContact<dim>& node,
                                       const ContactRounding& rounding) const override;
  [[nodiscard]] ContactEquations<dim> equations(const NodeContact<dim>& node) const override;
};

/// Coulomb's friction of surfaces that slide everywhere in a direction that is known: on the source
/// it is mu times the pressure against NodeContact::sliding.
template <int dim>
class Sliding : public ContactLaw<dim> {
 public:
  /// @param coefficient mu, >= 0
  explicit Sliding(double coefficient);

  [[nodiscard]] NodeStatus next_status(const NodeContact<dim>& node,
                                       const ContactRounding& rounding) const override;
  [[nodiscard]] ContactEquations<dim> equations(const NodeContact<dim>& node) const override;

 protected:
  [[nodiscard]] double coefficient() const { return coefficient_; }

 private:
  double coefficient_;
};

/// Coulomb's friction: the source sticks as long as the friction stays below mu times the pressure,
/// and slides against it beyond that (Hueber, Stadler and Wohlmuth 2008, 3).
template <int dim>
class Coulomb : public Sliding<dim> {
 public:
  using Sliding<dim>::Sliding;

  [[nodiscard]] NodeStatus next_status(const NodeContact<dim>& node,
                                       const ContactRounding& rounding) const override;
  [[nodiscard]] Components<dim> next_sliding(const NodeContact<dim>& node) const override;
  [[nodiscard]] NodeStatus touching() const override { return NodeStatus::stick; }
  [[nodiscard]] ContactEquations<dim> equations(const NodeContact<dim>& node) const override;
};

}  // namespace geneva::fem
