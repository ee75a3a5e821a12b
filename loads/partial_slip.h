#pragma once

#include <vector>

namespace geneva::loads {

/// Friction between like bodies that are pressed together and then moved along each other to and
/// fro while the pressure stays: C. Cattaneo (1938), R. D. Mindlin (1949), in reverse Mindlin and
/// Deresiewicz (1953); K. L. Johnson, Contact Mechanics, 1985, 7.2 and 7.4. Under a circle the
/// friction across the motion, of the order of nu/(4 - 2 nu), is left out.
class PartialSlip {
 public:
  enum class Shape { line, circle };

  /// @param bound mu P of the whole contact, > 0; forces have its unit
  PartialSlip(Shape shape, double bound);

  /// Goes on to a tangential force, |force| <= bound. What an earlier reversal left is forgotten
  /// where the force goes beyond it.
  void move_to(double force);

  /// c/a of the zone that sticks while the force goes on as it did last: (1 - Q/(mu P))^(1/2) of a
  /// line, ^(1/3) of a circle, of a reversal with half the change of Q; 0..1.
  [[nodiscard]] double stick_radius() const;

  /// Share of the contact's area that sticks: c/a of a line, (c/a)^2 of a circle.
  [[nodiscard]] double sticking_share() const;

  /// q/(mu p0) at a distance from the middle over a; the sign is that of the force.
  [[nodiscard]] double traction(double distance) const;

 private:
  /// c/a of a first loading by that share of the bound.
  [[nodiscard]] double radius_of(double share) const;
  /// q/(mu p0) of a first loading, with the sign of the share.
  [[nodiscard]] double first_loading(double share, double distance) const;

  Shape shape_;
  double bound_;
  std::vector<double> turns_{0.};  ///< forces over the bound: 0, reversals, the force of now
};

}  // namespace geneva::loads
