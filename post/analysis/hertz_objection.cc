#include "post/analysis/hertz_objection.h"

#include <fmt/format.h>

#include <algorithm>

#include "post/analysis/surface_body.h"

namespace geneva::post {

template <int dim>
std::string hertz_objection(const fem::Solution<dim>& solution,
                            const fem::ContactResult<dim>& contact, const double half_width) {
  // Over a wider arc the gap in a round hole is no parabola: Hertz is then off by a few per cent
  // (K. L. Johnson 1985, section 5.3, after Persson).
  constexpr double widest_over_radius = 0.3;
  if (!contact.has_one_curvature)
    return fmt::format(
        "the contact '{} -> {}' reaches over parts of different curvature: Hertz's closed form "
        "does not apply and is left out",
        contact.source, contact.target);
  for (const int circle : {contact.source_circle, contact.target_circle})
    if (circle >= 0 && solution.mesh.circles[static_cast<std::size_t>(circle)].ring_radius > 0.)
      return fmt::format(
          "the contact '{} -> {}' is one of a torus, whose curvature changes along it: Hertz's "
          "closed form is left out",
          contact.source, contact.target);
  const auto [flatter, rounder] =
      std::minmax({curvature(solution, contact.source_circle, contact.source_is_convex),
                   curvature(solution, contact.target_circle, contact.target_is_convex)});
  if (flatter >= 0. || half_width * rounder <= widest_over_radius) return "";
  return fmt::format(
      "the contact '{} -> {}' encloses its source: its half-width is {:.2g} of the radius, and "
      "Hertz's closed form, which is for at most {:.2g}, is left out",
      contact.source, contact.target, half_width * rounder, widest_over_radius);
}

template std::string hertz_objection(const fem::Solution<2>&, const fem::ContactResult<2>&, double);
template std::string hertz_objection(const fem::Solution<3>&, const fem::ContactResult<3>&, double);

}  // namespace geneva::post
