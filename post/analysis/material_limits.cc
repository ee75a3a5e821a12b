#include "post/analysis/material_limits.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "loads/contact_limits.h"
#include "post/analysis/surface_body.h"

namespace geneva::post {

namespace {

/// Whether a contact is a line or a circle, by Hertz; nothing of others.
std::optional<bool> is_line_contact(const ContactAnalysis<2>& analysis) {
  if (!analysis.hertz) return std::nullopt;
  return analysis.hertz->line.has_value();
}
std::optional<bool> is_line_contact(const ContactAnalysis<3>& analysis) {
  if (!analysis.hertz || (!analysis.hertz->line && !analysis.hertz->is_circle()))
    return std::nullopt;
  return analysis.hertz->line.has_value();
}

/// How deep below a contact a place is; nothing of one that is further beside it than it is wide.
std::optional<double> depth_below(const fem::Solution<2>& solution, const std::size_t pair,
                                  const ContactAnalysis<2>& analysis,
                                  const fem::Components<2>& place) {
  const dealii::Tensor<1, 2> from = dealii::Point<2>(place[0], place[1]) - analysis.centre.place;
  const double depth = std::abs(from * analysis.centre.normal);
  const double beside = std::sqrt(std::max(0., from.norm_square() - depth * depth));
  if (beside > 2. * solution.contacts[pair].half_width) return std::nullopt;
  return depth;
}
std::optional<double> depth_below(const fem::Solution<3>& /*solution*/, const std::size_t /*pair*/,
                                  const ContactAnalysis<3>& analysis,
                                  const fem::Components<3>& place) {
  const dealii::Point<3> at(place[0], place[1], place[2]);
  if (std::abs(analysis.frame.distance_across(at)) > 2. * analysis.half_width) return std::nullopt;
  return std::abs(analysis.frame.depth(at));
}

/// [Pa]
loads::ContactLimits limits_of(const bool is_line, const double poissons_ratio,
                               const double friction, const double yield) {
  const loads::ContactLimits limits = is_line ? loads::line_contact_limits(poissons_ratio, friction)
                                              : loads::point_contact_limits(poissons_ratio);
  return {limits.first_yield * yield, limits.shakedown * yield};
}

/// [Pa]
loads::ContactLimits layered_limits(const bool is_line, const double poissons_ratio,
                                    const double friction, const loads::HardenedLayer& layer,
                                    const double core, const double width_per_pressure) {
  return is_line
             ? loads::layered_line_limits(poissons_ratio, friction, layer, core, width_per_pressure)
             : loads::layered_point_limits(poissons_ratio, layer, core, width_per_pressure);
}

}  // namespace

template <int dim>
std::vector<MaterialLimit> material_limits(const fem::Solution<dim>& solution,
                                           const fem::ContactResult<dim>& contact,
                                           const ContactAnalysis<dim>& analysis,
                                           const loads::Allowables& allowed,
                                           const double friction) {
  using Kind = MaterialLimit::Kind;
  std::vector<MaterialLimit> found;
  const std::optional<bool> is_line = is_line_contact(analysis);
  const std::set<unsigned int> touching{body_of(solution, contact.source),
                                        body_of(solution, contact.target)};
  for (const unsigned int touched : touching) {
    const fem::Body<dim>& body = solution.problem.bodies[touched];
    const auto yield = allowed.yield_strengths.find(body.name);
    if (is_line && yield != allowed.yield_strengths.end()) {
      const auto layer = allowed.layers.find(body.name);
      const bool has_layer = layer != allowed.layers.end();
      const double nu = body.material.poissons_ratio;
      const loads::ContactLimits limits =
          has_layer ? layered_limits(*is_line, nu, friction, layer->second, yield->second,
                                     analysis.hertz->half_width() / analysis.hertz->peak_pressure())
                    : limits_of(*is_line, nu, friction, yield->second);
      found.push_back({Kind::first_yield, "first yield, " + body.name, limits.first_yield,
                       has_layer ? "below it neither the hardened layer nor the core yields"
                                 : "below it no point of the material yields"});
      found.push_back({Kind::shakedown, "shakedown, " + body.name, limits.shakedown,
                       "below it the material yields at first and is elastic again under any "
                       "number of passes"});
    }
    if (const auto flank = allowed.flank_pressures.find(body.name);
        flank != allowed.flank_pressures.end())
      found.push_back({Kind::flanks, "pitting, " + body.name, flank->second,
                       "below it flanks and rolling contacts of this material bear any number of "
                       "passes without pits"});
  }
  return found;
}

template <int dim>
bool is_in_layer(const fem::Solution<dim>& solution, const Results<dim>& results,
                 const loads::Allowables& allowed, const std::size_t body) {
  const auto layer = allowed.layers.find(solution.problem.bodies[body].name);
  if (layer == allowed.layers.end()) return false;
  for (std::size_t pair = 0; pair < results.contacts.size(); ++pair) {
    const auto depth =
        depth_below(solution, pair, results.contacts[pair], results.max_von_mises[body].place);
    if (depth && *depth < layer->second.depth) return true;
  }
  return false;
}

template std::vector<MaterialLimit> material_limits(const fem::Solution<2>&,
                                                    const fem::ContactResult<2>&,
                                                    const ContactAnalysis<2>&,
                                                    const loads::Allowables&, double);
template std::vector<MaterialLimit> material_limits(const fem::Solution<3>&,
                                                    const fem::ContactResult<3>&,
                                                    const ContactAnalysis<3>&,
                                                    const loads::Allowables&, double);
template bool is_in_layer(const fem::Solution<2>&, const Results<2>&, const loads::Allowables&,
                          std::size_t);
template bool is_in_layer(const fem::Solution<3>&, const Results<3>&, const loads::Allowables&,
                          std::size_t);

}  // namespace geneva::post
