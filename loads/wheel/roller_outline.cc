#include "loads/wheel/roller_outline.h"

#include <array>
#include <cmath>

#include "loads/pi.h"
#include "loads/require.h"
#include "loads/wheel/outline_shapes.h"
#include "loads/wheel/refuse.h"

namespace geneva::loads {

namespace {

constexpr double half_guide = 2.5 * degree;

/// Quarters of a circle from its top on, with a narrow arc about its bottom.
Loop guided_circle(const Point& centre, const double radius, const bool clockwise,
                   const std::string& surface) {
  const double turn = clockwise ? -1. : 1.;
  const std::array<double, 5> angles{pi / 2., pi / 2. + turn * pi / 2.,
                                     pi / 2. + turn * (pi - half_guide),
                                     pi / 2. + turn * (pi + half_guide), pi / 2. + turn * 1.5 * pi};
  const auto at = [&](const std::size_t i) {
    const double angle = angles[i % angles.size()];
    return Point{centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)};
  };
  constexpr std::size_t guide = 2;
  Loop loop;
  for (std::size_t i = 0; i < angles.size(); ++i)
    loop.push_back(arc(at(i), at(i + 1), centre, clockwise, i == guide ? "roller guide" : surface));
  return loop;
}

/// @param diameter of the roller [m]
void check(const Stud& stud, const double diameter) {
  require_not_negative("bore clearance of the roller", stud.clearance, "m");
  constexpr double loosest = 0.1;
  if (stud.clearance > loosest * stud.bore_diameter)
    refuse(
        "bore clearance of the roller is {:.6g} mm: it may be a tenth of its bore at most, {:.6g} "
        "mm",
        mm(stud.clearance), mm(loosest * stud.bore_diameter));
  constexpr double widest = 0.95;
  if (stud.bore_diameter > widest * diameter)
    refuse(
        "bore diameter of the roller is {:.6g} mm: a ring of {:.6g} mm is too thin to be modelled; "
        "give {:.6g} mm at most, or no bore clearance",
        mm(stud.bore_diameter), mm(diameter), mm(widest * diameter));
  const double radius = 0.5 * (stud.bore_diameter - stud.clearance);
  if (stud.core_radius >= radius)
    refuse(
        "pin core radius is {:.6g} mm: the core must lie inside the roller's stud of radius {:.6g} "
        "mm",
        mm(stud.core_radius), mm(radius));
}

}  // namespace

std::vector<Outline> roller_outlines(const Outline& pin, const Stud& stud) {
  const Segment& first = pin.loops.front().front();
  const Point centre = first.centre;
  const double radius = std::hypot(first.start.x - centre.x, first.start.y - centre.y);
  check(stud, 2. * radius);
  const double stud_radius = 0.5 * (stud.bore_diameter - stud.clearance);
  const Point of_stud{centre.x, centre.y + 0.5 * stud.clearance};
  return {{pin.name,
           {guided_circle(centre, radius, false, "pin"),
            guided_circle(centre, 0.5 * stud.bore_diameter, true, "roller bore")}},
          {"stud",
           {circle(of_stud, stud_radius, false, "stud"),
            circle(of_stud, stud.core_radius, true, "pin core")}}};
}

}  // namespace geneva::loads
