#include "loads/pin/pin_profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "loads/pi.h"
#include "loads/require.h"

namespace geneva::loads {

namespace {

/// Share of b/(L/2) by which Johns and Gohar keep the logarithm finite at the ends.
constexpr double end_relief = 0.3033;

double drop(const Cylinder& /*unused*/, const double /*z*/) { return 0.; }

double drop(const Crown& crown, const double z) {
  const double R = crown.radius;
  const double along = std::min(std::abs(z), R);
  return along * along / (R + std::sqrt(R * R - along * along));
}

double drop(const LogarithmicProfile& profile, const double z) {
  const double half = profile.length / 2.;
  const double relief = 1. - end_relief * profile.half_width / half;
  const double share = std::min(std::abs(z) / half, 1.);
  const double rest = 1. - relief * share * share;
  const double beyond = std::max(0., std::abs(z) / half - 1.);
  return profile.amplitude * (-std::log(rest) + beyond * 2. * relief / (1. - relief));
}

double drop(const ProfileTable& table, const double z) {
  const auto& places = table.places;
  const auto above = std::upper_bound(places.begin(), places.end(), z) - places.begin();
  const auto end = static_cast<std::ptrdiff_t>(places.size());
  const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above, 1, end - 1));
  const double share = std::clamp((z - places[i - 1]) / (places[i] - places[i - 1]), 0., 1.);
  return table.drops[i - 1] + share * (table.drops[i] - table.drops[i - 1]);
}

/// Clearance at a distance inwards from a broken edge; beyond the edge as at it.
double drop(const EdgeBreak& edge, const double inwards) {
  const double s = std::max(inwards, 0.);
  if (edge.kind == EdgeBreak::Kind::sharp || s >= edge.size) return 0.;
  const double left = edge.size - s;
  if (edge.kind == EdgeBreak::Kind::chamfered) return left;
  return edge.size - std::sqrt(edge.size * edge.size - left * left);
}

}  // namespace

double PinClearance::at(const double z) const {
  const EdgeBreak end{EdgeBreak::Kind::chamfered, pin_chamfer};
  double clearance = std::visit([&](const auto& shape) { return drop(shape, z); }, profile);
  clearance += drop(wall_edge, wall_half - std::abs(z)) + drop(end, z - lower_end);
  if (upper_is_free) clearance += drop(end, upper_end - z);
  return clearance + z * std::tan(tilt);
}

LogarithmicProfile logarithmic_profile(const double force, const double length,
                                       const double contact_modulus, const double half_width) {
  require_positive("profile load", force, "N");
  require_positive_length("profile length", length);
  require_positive("contact modulus", contact_modulus, "Pa");
  require_positive_length("half-width of the contact", half_width);
  if (half_width >= length)
    throw base::InputError(
        fmt::format("half-width of the contact is {:.6g} mm: it must be less than the profile "
                    "length {:.6g} mm for a line contact",
                    1e3 * half_width, 1e3 * length));
  return {force / (pi * length * contact_modulus), length, half_width};
}

void check(const PinProfile& profile, const double half_length) {
  if (const auto* crown = std::get_if<Crown>(&profile); crown && crown->radius < half_length)
    throw base::InputError(
        fmt::format("crown radius is {:.6g} mm: it must be at least the {:.6g} mm from the middle "
                    "of the contact to the pin's end",
                    1e3 * crown->radius, 1e3 * half_length));
  const auto* table = std::get_if<ProfileTable>(&profile);
  if (table == nullptr) return;
  if (table->places.size() < 2 || table->places.size() != table->drops.size())
    throw base::InputError("a profile needs two or more points (z, height)");
  const auto& z = table->places;
  if (std::adjacent_find(z.begin(), z.end(), [](double a, double b) { return !(a < b); }) !=
      z.end())
    throw base::InputError("the places z of a profile must increase from row to row");
}

}  // namespace geneva::loads
