#include "model/pin_extrusion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "loads/hertz.h"
#include "loads/pi.h"
#include "model/pin_in_space.h"

namespace geneva::model {

namespace {

using Hold = PinHolding::Hold;
using PinShape = PinCase::Profile;

/// Cells in a line contact are this much longer than wide: the pressure changes slowly along the
/// pin.
constexpr double longest_cells = 6.;
constexpr double cells_at_an_end = 2.;
/// A logarithmic profile falls off within a few contact widths from its ends: with cells of aspect
/// ratio 6 the line load there is uneven by 5 %, with 3 by 0.3 %.
constexpr double cells_in_logarithm = 3.;
/// At a rounded edge the layers over those in the middle are this many times the climb onto the
/// round over the half-length. On Johnson's wheel with a radius of a 68th of the thickness the peak
/// is then within 3 % with a million unknowns; with three times thicker layers within 7 %, with
/// three times thinner ones it takes half as long again.
constexpr double climbs_in_thickness = 9.;
constexpr double thinnest_layers = 1e-3;
/// Longest cells of the pin's free lengths over its diameter, which bend.
constexpr double longest_bent_cells = 0.4;

using Grading = std::optional<mesh::Grading>;

/// Of one part of the pin's length; far more than any pin needs that can be made.
constexpr double most_layers = 1000.;

/// Adds planes from the last one to `end`, in layers of about the given height in the mean.
/// @throws base::InputError if that takes too many
void add_layers(std::vector<double>& planes, const double end, const double height,
                const Grading& grading) {
  const double start = planes.back();
  const double rounding = 1e-9 * height;
  if (end - start <= rounding) return;
  if (!((end - start) / height < most_layers))
    throw base::InputError(
        fmt::format("a part of the pin is {:.3g} mm long, which takes {:.3g} layers of cells of "
                    "{:.3g} mm, more than {:.0f}: its lengths do not fit its diameter or the "
                    "contact's width",
                    1e3 * (end - start), (end - start) / height, 1e3 * height, most_layers));
  const int layers = std::max(1, static_cast<int>(std::lround((end - start) / height)));
  const double even_start = grading ? mesh::even(*grading, start) : start;
  const double even_end = grading ? mesh::even(*grading, end) : end;
  for (int i = 1; i < layers; ++i) {
    const double place = even_start + (even_end - even_start) * i / layers;
    planes.push_back(grading ? mesh::graded(*grading, place) : place);
  }
  planes.push_back(end);
}

/// Hertz's contact of the crowned pin.
loads::HertzEllipse crowned_contact(const MechanismCase& mechanism, const MechanismState& state) {
  const double crown = mechanism.space->crown_radius;
  const double radius = state.sizes.pin_diameter / 2.;
  return loads::hertz_ellipse(state.load.force, std::max(crown, radius), std::min(crown, radius),
                              contact_modulus(mechanism));
}

/// How much longer than wide the cells are. The pressure changes faster along a crowned pin (half
/// of the ratio of its elliptical contact's axes) and along a tilted one, which touches at an end.
double aspect_ratio(const MechanismCase& mechanism, const MechanismState& state) {
  const PinCase& pin = *mechanism.space;
  if (pin.profile != PinShape::crown && pin.tilt != 0.) return cells_at_an_end;
  if (pin.profile == PinShape::logarithmic) return cells_in_logarithm;
  if (pin.profile != PinShape::crown) return longest_cells;
  const loads::HertzEllipse ellipse = crowned_contact(mechanism, state);
  const double ratio = ellipse.semi_axis_long / ellipse.semi_axis_short;
  return std::clamp(ratio / 2., 1., longest_cells);
}

/// How far the contact climbs onto the slot's rounded edge, as a length scale: where the round of
/// radius r has fallen off by F/(π t E*).
double climb(const MechanismCase& mechanism, const MechanismState& state) {
  const double fall =
      state.load.force / (loads::pi * state.sizes.thickness * contact_modulus(mechanism));
  return std::sqrt(2. * mechanism.space->slot_edge.size * fall);
}

}  // namespace

std::vector<mesh::Extrusion> extrusions(const std::vector<std::string>& bodies,
                                        const MechanismCase& mechanism, const MechanismState& state,
                                        const double cell) {
  const MechanismSizes& sizes = state.sizes;
  const PinLengths lengths = pin_lengths(mechanism, sizes);
  const Hold hold = mechanism.pin_holding.hold;
  const double half = sizes.thickness / 2.;
  const double height = aspect_ratio(mechanism, state) * cell;
  const double bent = std::min(height, longest_bent_cells * sizes.pin_diameter);
  const Grading layers = grading(mechanism, state);
  const bool held_twice = hold == Hold::both_ends;
  const bool is_half = is_half_model(mechanism);
  mesh::Extrusion wheel{{is_half ? 0. : -half}, is_half ? "wheel middle" : "faces", "faces"};
  add_layers(wheel.planes, half, height, layers);
  mesh::Extrusion rod{{-half - (held_twice ? lengths.root_gap : lengths.overhang)},
                      held_twice ? "pin root" : "pin tip",
                      hold == Hold::core ? "pin tip" : "pin root"};
  if (is_half)
    rod = {{0.}, "pin middle", "pin root"};
  else
    add_layers(rod.planes, -half, bent, layers);
  add_layers(rod.planes, half, height, layers);
  add_layers(rod.planes, half + (hold == Hold::core ? lengths.overhang : lengths.root_gap), bent,
             layers);
  std::vector<mesh::Extrusion> result;
  for (const std::string& body : bodies) result.push_back(body == "wheel" ? wheel : rod);
  return result;
}

std::optional<mesh::Grading> grading(const MechanismCase& mechanism, const MechanismState& state) {
  const PinCase& pin = *mechanism.space;
  const bool is_broken = pin.slot_edge.kind != loads::EdgeBreak::Kind::sharp;
  const double half = state.sizes.thickness / 2. - (is_broken ? pin.slot_edge.size : 0.);
  if (half <= 0. || pin.profile == PinShape::logarithmic) return std::nullopt;
  if (pin.profile == PinShape::crown && crowned_contact(mechanism, state).semi_axis_long < half)
    return std::nullopt;
  mesh::Grading result{half};
  if (pin.slot_edge.kind == loads::EdgeBreak::Kind::rounded)
    result.thickness_at_ends = std::clamp(climbs_in_thickness * climb(mechanism, state) / half,
                                          thinnest_layers, result.thickness_at_ends);
  return result;
}

}  // namespace geneva::model
