#include "model/pin_in_space.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "loads/hertz.h"
#include "loads/pi.h"
#include "model/block_dimensions.h"
#include "model/input/parameters.h"
#include "model/wheel_twist.h"

namespace geneva::model {

namespace {

using Hold = PinCase::Hold;
using Profile = PinCase::Profile;

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
/// Free lengths beside the wheel over the pin diameter, unless the case gives them.
constexpr double default_free_length = 0.25;

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

double modulus_of(const MechanismCase& mechanism) {
  const auto elastic = [](const CaseMaterial& material) {
    return loads::Elastic{material.youngs_modulus, material.poissons_ratio};
  };
  return loads::contact_modulus(elastic(mechanism.pin), elastic(mechanism.wheel));
}

loads::PinProfile profile_of(const MechanismCase& mechanism, const MechanismState& state) {
  const PinCase& pin = *mechanism.space;
  switch (pin.profile) {
    case Profile::crown:
      return loads::Crown{pin.crown_radius};
    case Profile::table:
      return pin.table;
    case Profile::cylindrical:
      return loads::Cylinder{};
    case Profile::logarithmic:
      break;
  }
  const double length = pin.profile_length.value_or(state.sizes.thickness);
  const double modulus = modulus_of(mechanism);
  double load = pin.profile_load.value_or(state.load.force);
  if (pin.profile_amplitude) load = *pin.profile_amplitude * loads::pi * length * modulus;
  const loads::HertzLine hertz =
      loads::hertz_line(load / length, state.sizes.pin_diameter / 2., modulus);
  return loads::logarithmic_profile(load, length, modulus, hertz.half_width);
}

/// Hertz's contact of the crowned pin.
loads::HertzEllipse crowned_contact(const MechanismCase& mechanism, const MechanismState& state) {
  const double crown = mechanism.space->crown_radius;
  const double radius = state.sizes.pin_diameter / 2.;
  return loads::hertz_ellipse(state.load.force, std::max(crown, radius), std::min(crown, radius),
                              modulus_of(mechanism));
}

/// How much longer than wide the cells are. The pressure changes faster along a crowned pin (half
/// of the ratio of its elliptical contact's axes) and along a tilted one, which touches at an end.
double aspect_ratio(const MechanismCase& mechanism, const MechanismState& state) {
  const PinCase& pin = *mechanism.space;
  if (pin.profile != Profile::crown && pin.tilt != 0.) return cells_at_an_end;
  if (pin.profile == Profile::logarithmic) return cells_in_logarithm;
  if (pin.profile != Profile::crown) return longest_cells;
  const loads::HertzEllipse ellipse = crowned_contact(mechanism, state);
  const double ratio = ellipse.semi_axis_long / ellipse.semi_axis_short;
  return std::clamp(ratio / 2., 1., longest_cells);
}

/// How far the contact climbs onto the slot's rounded edge, as a length scale: where the round of
/// radius r has fallen off by F/(π t E*).
double climb(const MechanismCase& mechanism, const MechanismState& state) {
  const double fall =
      state.load.force / (loads::pi * state.sizes.thickness * modulus_of(mechanism));
  return std::sqrt(2. * mechanism.space->slot_edge.size * fall);
}

loads::PinHold hold_of(const PinCase& pin) {
  if (pin.hold == Hold::both_ends) return loads::PinHold::both_ends;
  return pin.hold == Hold::core ? loads::PinHold::core : loads::PinHold::one_end;
}

/// Line contacts are those of a straight wall.
/// @throws base::InputError if the contact reaches the slot's round bottom
void refuse_bottom(const MechanismCase& mechanism, const MechanismState& state) {
  if (mechanism.is_local || !state.wheel) return;
  const double line_load = state.load.force / state.sizes.thickness;
  const double reach =
      loads::hertz_line(line_load, state.sizes.pin_diameter / 2., modulus_of(mechanism)).half_width;
  const double from_bottom = std::visit(
      [&](const auto& wheel) {
        return std::abs(state.load.pin_distance - slot_bottom_centre(wheel));
      },
      *state.wheel);
  if (from_bottom < reach)
    throw base::InputError(
        "the pin stands in the round bottom of its slot: line contacts along the pin are known on "
        "its straight walls");
}

}  // namespace

PinLengths pin_lengths(const PinCase& pin, const MechanismSizes& sizes) {
  const double usual = default_free_length * sizes.pin_diameter;
  const double gap = pin.root_gap.value_or(pin.hold == Hold::core ? 0. : usual);
  if (pin.hold == Hold::both_ends) return {gap, 0.};
  const double free_ends = pin.hold == Hold::core ? 2. : 1.;
  if (pin.length) return {gap, (*pin.length - gap - sizes.thickness) / free_ends};
  return {gap, pin.overhang.value_or(usual)};
}

bool is_half_model(const MechanismCase& mechanism) {
  return mechanism.space && mechanism.space->hold == Hold::both_ends &&
         mechanism.space->tilt == 0. && mechanism.space->profile != Profile::table;
}

loads::PinClearance pin_clearance(const MechanismCase& mechanism, const MechanismState& state) {
  const PinCase& pin = *mechanism.space;
  const PinLengths lengths = pin_lengths(pin, state.sizes);
  const double half = state.sizes.thickness / 2.;
  loads::PinClearance clearance;
  clearance.profile = profile_of(mechanism, state);
  clearance.tilt = pin.tilt;
  clearance.wall_half = half;
  clearance.wall_edge = pin.slot_edge;
  const bool held_twice = pin.hold == Hold::both_ends;
  clearance.lower_end = -half - (held_twice ? lengths.root_gap : lengths.overhang);
  clearance.upper_is_free = pin.hold == Hold::core;
  clearance.upper_end = half + (clearance.upper_is_free ? lengths.overhang : lengths.root_gap);
  clearance.pin_chamfer = held_twice ? 0. : pin.end_chamfer;
  loads::check(clearance.profile, std::max(-clearance.lower_end, clearance.upper_end));
  return clearance;
}

std::optional<loads::PinBeam> pin_beam(const MechanismCase& mechanism,
                                       const MechanismSizes& sizes) {
  const PinCase& pin = *mechanism.space;
  if (pin.hold == Hold::core) return std::nullopt;
  const PinLengths lengths = pin_lengths(pin, sizes);
  return loads::PinBeam{sizes.pin_diameter,
                        sizes.thickness,
                        lengths.root_gap,
                        lengths.overhang,
                        pin.hold == Hold::both_ends,
                        mechanism.pin.youngs_modulus,
                        mechanism.pin.poissons_ratio};
}

loads::PinLine pin_line(const MechanismCase& mechanism, const MechanismState& state) {
  for (const CaseMaterial& material : {mechanism.pin, mechanism.wheel})
    if (material.poissons_ratio < 0.)
      throw base::InputError(
          fmt::format("Poisson's ratio {:.6g}: line contacts along the pin are known from 0 on",
                      material.poissons_ratio));
  refuse_bottom(mechanism, state);
  const double radius = state.sizes.pin_diameter / 2.;
  return {{mechanism.pin.youngs_modulus, mechanism.pin.poissons_ratio},
          {mechanism.wheel.youngs_modulus, mechanism.wheel.poissons_ratio},
          radius,
          radius,
          pin_clearance(mechanism, state),
          hold_of(*mechanism.space),
          wheel_twist(mechanism, state),
          mechanism.space->hold == Hold::core
              ? block_dimensions(mechanism, state.sizes).pin_core_radius
              : 0.};
}

std::optional<KnownPinLine> pin_line_contact(const MechanismCase& mechanism,
                                             const MechanismState& state) {
  constexpr double accuracy = 5e-4;
  if (!mechanism.space) return std::nullopt;
  try {
    const loads::PinLine pin = pin_line(mechanism, state);
    return KnownPinLine{pin, loads::pin_line_contact(pin, state.load.force, accuracy)};
  } catch (const base::InputError&) {
    return std::nullopt;
  }
}

std::vector<mesh::Extrusion> extrusions(const std::vector<std::string>& bodies,
                                        const MechanismCase& mechanism, const MechanismState& state,
                                        const double cell) {
  const PinCase& pin = *mechanism.space;
  const MechanismSizes& sizes = state.sizes;
  const PinLengths lengths = pin_lengths(pin, sizes);
  const double half = sizes.thickness / 2.;
  const double height = aspect_ratio(mechanism, state) * cell;
  const double bent = std::min(height, longest_bent_cells * sizes.pin_diameter);
  const Grading layers = grading(mechanism, state);
  const bool held_twice = pin.hold == Hold::both_ends;
  const bool is_half = is_half_model(mechanism);
  mesh::Extrusion wheel{{is_half ? 0. : -half}, is_half ? "wheel middle" : "faces", "faces"};
  add_layers(wheel.planes, half, height, layers);
  mesh::Extrusion rod{{-half - (held_twice ? lengths.root_gap : lengths.overhang)},
                      held_twice ? "pin root" : "pin tip",
                      pin.hold == Hold::core ? "pin tip" : "pin root"};
  if (is_half)
    rod = {{0.}, "pin middle", "pin root"};
  else
    add_layers(rod.planes, -half, bent, layers);
  add_layers(rod.planes, half, height, layers);
  add_layers(rod.planes, half + (pin.hold == Hold::core ? lengths.overhang : lengths.root_gap),
             bent, layers);
  std::vector<mesh::Extrusion> result;
  for (const std::string& body : bodies) result.push_back(body == "wheel" ? wheel : rod);
  return result;
}

std::optional<mesh::Grading> grading(const MechanismCase& mechanism, const MechanismState& state) {
  const PinCase& pin = *mechanism.space;
  const bool is_broken = pin.slot_edge.kind != loads::EdgeBreak::Kind::sharp;
  const double half = state.sizes.thickness / 2. - (is_broken ? pin.slot_edge.size : 0.);
  if (half <= 0. || pin.profile == Profile::logarithmic) return std::nullopt;
  if (pin.profile == Profile::crown && crowned_contact(mechanism, state).semi_axis_long < half)
    return std::nullopt;
  mesh::Grading result{half};
  if (pin.slot_edge.kind == loads::EdgeBreak::Kind::rounded)
    result.thickness_at_ends = std::clamp(climbs_in_thickness * climb(mechanism, state) / half,
                                          thinnest_layers, result.thickness_at_ends);
  return result;
}

std::string pin_holder(const PinCase& pin) {
  return pin.hold == Hold::core ? "pin core" : "pin root";
}

}  // namespace geneva::model
