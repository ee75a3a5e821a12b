#include "loads/material_limits.h"

#include "loads/contact_limits.h"

namespace geneva::loads {

namespace {

/// [Pa]
ContactLimits yield_limits(const double poissons_ratio, const ContactKind& kind,
                           const double yield) {
  const ContactLimits limits = kind.is_line()
                                   ? line_contact_limits(poissons_ratio, kind.friction)
                                   : ellipse_contact_limits(kind.axis_ratio, poissons_ratio);
  return {limits.first_yield * yield, limits.shakedown * yield};
}

/// [Pa]
ContactLimits layered_limits(const double poissons_ratio, const ContactKind& kind,
                             const HardenedLayer& layer, const double core) {
  return kind.is_line()
             ? layered_line_limits(poissons_ratio, kind.friction, layer, core,
                                   kind.width_per_pressure)
             : layered_point_limits(poissons_ratio, layer, core, kind.width_per_pressure);
}

/// Whether there are closed forms of its limits.
bool is_known(const ContactKind& kind, const bool has_layer) {
  constexpr double most_friction = 1.;
  if (kind.is_line()) return kind.friction <= most_friction;
  return kind.friction == 0. && (kind.is_circle() || !has_layer);
}

}  // namespace

std::vector<MaterialLimit> material_limits(const TouchingBody& body,
                                           const std::optional<ContactKind>& kind,
                                           const Allowables& allowed) {
  using Kind = MaterialLimit::Kind;
  std::vector<MaterialLimit> found;
  const auto yield = allowed.yield_strengths.find(body.name);
  const auto layer = allowed.layers.find(body.name);
  const bool has_layer = layer != allowed.layers.end();
  if (kind && is_known(*kind, has_layer) && yield != allowed.yield_strengths.end()) {
    const ContactLimits limits =
        has_layer ? layered_limits(body.poissons_ratio, *kind, layer->second, yield->second)
                  : yield_limits(body.poissons_ratio, *kind, yield->second);
    found.push_back({Kind::first_yield, "first yield, " + body.name, limits.first_yield,
                     has_layer ? "below it neither the hardened layer nor the core yields"
                               : "below it no point of the material yields"});
    found.push_back(
        {Kind::shakedown, "shakedown, " + body.name, limits.shakedown,
         "below it the material yields at first and is elastic again under any number of passes"});
  }
  if (const auto flank = allowed.flank_pressures.find(body.name);
      flank != allowed.flank_pressures.end())
    found.push_back(
        {Kind::flanks, "pitting, " + body.name, flank->second,
         "below it gear flanks and rolling contacts of this material bear any number "
         "of passes without pits; a flag and no proof for what slides more than gears"});
  return found;
}

}  // namespace geneva::loads
