#include "loads/synthesis/crank_rocker.h"

#include <fmt/format.h>

#include <cmath>

#include "base/errors.h"
#include "loads/pi.h"
#include "loads/require.h"

namespace geneva::loads {

CrankRocker crank_rocker(const CrankRockerInput& input) {
  if (!(input.swing > 0. && input.swing < pi))
    throw base::InputError(
        fmt::format("swing of the rocker is {:.6g} deg: a crank-rocker's lies between 0 and 180 "
                    "deg; give a swing in this range",
                    input.swing / degree));
  require_positive_length("rocker CD", input.rocker);
  const double crank = input.rocker * std::sin(input.swing / 2.);
  const double coupler = input.pivot_distance;
  constexpr double margin = 1. + 1e-9;  // nearer, the crank passes a change point but for rounding
  if (!(std::isfinite(coupler) && coupler > margin * crank))
    throw base::InputError(fmt::format(
        "distance of the crank's pivot from the middle of the chord is {:.6g} mm: it must be "
        "finite "
        "and greater than half the chord, {:.6g} mm, or the crank cannot turn fully (Grashof); "
        "move the pivot out along the chord",
        1e3 * coupler, 1e3 * crank));
  const double height = input.rocker * std::cos(input.swing / 2.);
  const FourBar linkage{{-coupler, height}, {0., 0.}, crank, coupler, input.rocker, coupler, 0.};
  const double frame = frame_length(linkage);
  // tan(mu) = sqrt((BC^2 - AB^2)(CD^2 - AB^2))/(AB AD), with CD^2 - AB^2 the square of the height
  const double room = std::sqrt((coupler - crank) * (coupler + crank)) * height;
  return {linkage, Assembly::open, input.swing, 0., pi, frame, std::atan2(room, crank * frame)};
}

}  // namespace geneva::loads
