#include "loads/needle_bearing.h"

#include <fmt/format.h>

#include <cmath>

#include "base/errors.h"
#include "loads/pi.h"
#include "loads/require.h"

namespace geneva::loads {

namespace {

double in_mm(const double length) { return 1e3 * length; }

}  // namespace

double stud_diameter(const NeedleBearing& needles, const double bore_diameter) {
  return bore_diameter - 2. * needles.diameter;
}

double greatest_needle_load(const NeedleBearing& needles, const double force) {
  constexpr double stribeck = 5.;
  return stribeck * force / needles.count;
}

double needle_pressure(const NeedleBearing& needles, const double bore_diameter, const double force,
                       const Elastic& stud) {
  if (force == 0.) return 0.;
  const double curvature = 2. / needles.diameter + 2. / stud_diameter(needles, bore_diameter);
  return hertz_line(greatest_needle_load(needles, force) / needles.length, 1. / curvature,
                    contact_modulus(stud, stud))
      .peak_pressure;
}

std::vector<NeedleLimit> needle_limits(const Allowables& allowed) {
  std::vector<NeedleLimit> limits{
      {"needle on stud, dents (ISO 76)", static_needle_pressure,
       "below it a stud hardened to HRC 58 keeps dents of less than a ten-thousandth of the "
       "needle"}};
  const auto yield = allowed.yield_strengths.find("stud");
  if (yield == allowed.yield_strengths.end()) return limits;
  constexpr double steel = 0.3;  // first yield alone depends on it
  const auto layer = allowed.layers.find("stud");
  const double strength =
      layer == allowed.layers.end() ? yield->second : layer->second.yield_strength;
  limits.push_back({"needle on stud, shakedown, stud",
                    line_contact_limits(steel, 0.).shakedown * strength,
                    "below it the stud yields at first and is elastic again under any number of "
                    "passes"});
  return limits;
}

void check(const NeedleBearing& needles, const double bore_diameter) {
  require_positive_length("needle diameter", needles.diameter);
  require_positive_length("needle length", needles.length);
  constexpr int least = 3;
  if (needles.count < least)
    throw base::InputError(
        fmt::format("there are {} needles: a bearing has {} or more", needles.count, least));
  if (2. * needles.diameter >= bore_diameter)
    throw base::InputError(fmt::format(
        "needle diameter is {:.6g} mm: two needles leave no stud in a bore of {:.6g} mm; make them "
        "thinner or the bore greater",
        in_mm(needles.diameter), in_mm(bore_diameter)));
  const double pitch = bore_diameter - needles.diameter;
  const int most = static_cast<int>(pi / std::asin(needles.diameter / pitch));
  if (needles.count > most)
    throw base::InputError(fmt::format(
        "there are {} needles of {:.6g} mm: at most {} fit beside each other in a bore of {:.6g} "
        "mm",
        needles.count, in_mm(needles.diameter), most, in_mm(bore_diameter)));
}

}  // namespace geneva::loads
