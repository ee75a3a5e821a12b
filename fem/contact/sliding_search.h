#pragma once

#include <deque>
#include <vector>

#include "fem/contact/interface.h"

namespace geneva::fem {

/// Finds the directions in which the nodes of one contact in 3-D slide.
///
/// Friction acts against the slip, and the slip follows from the friction: to take the slip's
/// direction as the next one oscillates where the slip is small beside what the friction moves.
/// Each node therefore turns from its direction d to that of mu p d + c s with its slip s (P. Alart
/// and A. Curnier 1991), with c a stiffness that is too small rather than too large, and the turns
/// of all nodes together are extrapolated over the last steps (D. G. Anderson 1965; H. F. Walker
/// and P. Ni 2011).
class SlidingSearch {
 public:
  /// Puts the next directions of the nodes that slipped and go on to slip into `sliding`.
  /// @param interface with the directions that the state belongs to
  /// @param next status of its rows
  /// @return the maximum turn [rad] that such a node still has to make
  double advance(const ContactInterface<3>& interface, const ContactState& state,
                 const std::vector<NodeStatus>& next, std::vector<Components<3>>& sliding);

  /// Forgets the steps so far.
  void start_again() { steps_.clear(); }

 private:
  /// By row.
  struct Step {
    std::vector<bool> slips;
    std::vector<double> angle;  ///< of the direction along the tangents
    std::vector<double> turn;   ///< to the direction that follows from it
  };

  /// Turns by row that the extrapolation adds.
  [[nodiscard]] std::vector<double> extrapolated(const std::vector<double>& weight) const;

  std::deque<Step> steps_;
};

/// In the plane there is nothing to find: a node slides to one side or to the other.
class NoSlidingSearch {
 public:
  double advance(const ContactInterface<2>& /*interface*/, const ContactState& /*state*/,
                 const std::vector<NodeStatus>& /*next*/,
                 std::vector<Components<2>>& /*sliding*/) const {
    return 0.;
  }
  void start_again() const {}
};

}  // namespace geneva::fem
