#include "post/analysis/material_limits.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "post/analysis/surface_body.h"

namespace geneva::post {

namespace {

/// b/a of a contact: 0 of a line, 1 of a circle; nothing where Hertz does not apply.
std::optional<double> axis_ratio(const ContactAnalysis<2>& analysis) {
  if (!analysis.hertz) return std::nullopt;
  return analysis.hertz->line ? 0. : 1.;
}

/// An ellipse that is so long is a line to its materials.
constexpr double ratio_of_lines = 0.02;

std::optional<double> axis_ratio(const ContactAnalysis<3>& analysis) {
  if (!analysis.hertz) return std::nullopt;
  if (analysis.hertz->line) return 0.;
  if (analysis.hertz->is_circle()) return 1.;
  const loads::HertzEllipse& ellipse = *analysis.hertz->ellipse;
  const double ratio = ellipse.semi_axis_short / ellipse.semi_axis_long;
  return ratio < ratio_of_lines ? 0. : ratio;
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

}  // namespace

template <int dim>
std::vector<loads::MaterialLimit> material_limits(const fem::Solution<dim>& solution,
                                                  const fem::ContactResult<dim>& contact,
                                                  const ContactAnalysis<dim>& analysis,
                                                  const loads::Allowables& allowed,
                                                  const double friction) {
  std::optional<loads::ContactKind> kind;
  if (const std::optional<double> ratio = axis_ratio(analysis))
    kind = loads::ContactKind{*ratio, friction,
                              analysis.hertz->half_width() / analysis.hertz->peak_pressure()};
  std::vector<loads::MaterialLimit> found;
  for (const unsigned int touched : std::set<unsigned int>{body_of(solution, contact.source),
                                                           body_of(solution, contact.target)}) {
    const fem::Body<dim>& body = solution.problem.bodies[touched];
    for (const loads::MaterialLimit& limit :
         loads::material_limits({body.name, body.material.poissons_ratio}, kind, allowed))
      found.push_back(limit);
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

template std::vector<loads::MaterialLimit> material_limits(const fem::Solution<2>&,
                                                           const fem::ContactResult<2>&,
                                                           const ContactAnalysis<2>&,
                                                           const loads::Allowables&, double);
template std::vector<loads::MaterialLimit> material_limits(const fem::Solution<3>&,
                                                           const fem::ContactResult<3>&,
                                                           const ContactAnalysis<3>&,
                                                           const loads::Allowables&, double);
template bool is_in_layer(const fem::Solution<2>&, const Results<2>&, const loads::Allowables&,
                          std::size_t);
template bool is_in_layer(const fem::Solution<3>&, const Results<3>&, const loads::Allowables&,
                          std::size_t);

}  // namespace geneva::post
