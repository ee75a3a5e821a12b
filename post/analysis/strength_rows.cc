#include "post/analysis/strength_rows.h"

#include <fmt/format.h>

#include <map>
#include <set>

#include "fem/singular_places.h"

namespace geneva::post {

namespace {

/// The names that the drawn wheels and pins give to their surfaces; by whether it is round there.
const std::map<std::pair<std::string, bool>, std::string> drawn_places{
    {{"driving wall", true}, "bottom of the engaged slot"},
    {{"driving wall", false}, "driving wall of the engaged slot"},
    {{"opposite wall", true}, "bottom of the engaged slot"},
    {{"opposite wall", false}, "opposite wall of the engaged slot"},
    {{"slots", true}, "bottom of another slot"},
    {{"slots", false}, "wall of another slot"},
    {{"locking arcs", true}, "locking arc"}};

template <int dim>
std::string surface_at(const fem::Solution<dim>& solution, const fem::StressMaximum<dim>& maximum) {
  if (maximum.surface < 0) return "inside";
  const std::string& surface = solution.mesh.surfaces[static_cast<std::size_t>(maximum.surface)];
  const auto drawn = drawn_places.find({surface, maximum.is_round});
  if (drawn != drawn_places.end()) return drawn->second;
  return surface.empty() ? "surface without a name" : surface;
}

template <int dim>
std::string where(const fem::Solution<dim>& solution, const fem::StressMaximum<dim>& maximum) {
  return surface_at(solution, maximum) +
         (maximum.is_beside_contact() ? ", beside the contact" : "");
}

}  // namespace

template <int dim>
std::vector<NamedStress<dim>> named_stresses(const fem::Solution<dim>& solution) {
  std::vector<NamedStress<dim>> result;
  for (std::size_t i = 0; i < solution.strength.size(); ++i) {
    const fem::BodyStrength<dim>& body = solution.strength[i];
    const std::string& name = solution.problem.bodies[i].name;
    if (body.von_mises.value > 0.)
      result.push_back({name, "von Mises stress", body.von_mises, where(solution, body.von_mises),
                        body.von_mises.is_beside_contact(),
                        fem::is_clear(solution.singular, body.von_mises.place)});
    if (body.tensile.value > 0.)
      result.push_back({name, "tensile stress", body.tensile, where(solution, body.tensile),
                        body.tensile.is_beside_contact(),
                        fem::is_clear(solution.singular, body.tensile.place)});
  }
  return result;
}

template <int dim>
std::vector<ComparisonRow> strength_rows(const fem::Solution<dim>& solution) {
  std::vector<ComparisonRow> rows;
  for (const NamedStress<dim>& stress : named_stresses(solution)) {
    ComparisonRow row{stress.name + ", " + stress.body,
                      base::Dimension::stress,
                      std::nullopt,
                      std::nullopt,
                      stress.is_bounded,
                      std::nullopt,
                      std::nullopt};
    if (stress.is_bounded) {
      row.computed = stress.maximum.value;
      row.error = stress.maximum.total_error();
    }
    rows.push_back(row);
  }
  return rows;
}

namespace {

const char* words_of(const fem::Singularity why) {
  switch (why) {
    case fem::Singularity::end_of_support:
      return "ends of the support";
    case fem::Singularity::re_entrant_corner:
      return "re-entrant corners of";
    default:
      return "a corner of";
  }
}

/// The singular places, in words.
template <int dim>
std::string line_of_left_out(const fem::Solution<dim>& solution) {
  std::set<std::string> named;
  for (const fem::SingularPlace<dim>& place : solution.singular) {
    const std::string& surface = solution.mesh.surfaces[place.surface];
    named.insert(surface.empty() ? std::string(words_of(place.why)) + " a surface without a name"
                                 : fmt::format("{} '{}'", words_of(place.why), surface));
  }
  std::string text;
  for (const std::string& name : named)
    text += (text.empty() ? "left out, since unbounded: " : ", ") + name;
  return text;
}

}  // namespace

template <int dim>
std::string strength_line(const fem::Solution<dim>& solution) {
  const char* const begin =
      fem::has_contact(solution.problem) ? "outside the contact's own field: " : "where: ";
  std::string line;
  for (const NamedStress<dim>& stress : named_stresses(solution))
    line += fmt::format("{}{} of '{}': {}", line.empty() ? begin : "; ", stress.name, stress.body,
                        stress.where);
  const std::string left_out = line_of_left_out(solution);
  return line.empty() ? line : line + (left_out.empty() ? "" : "; " + left_out) + '\n';
}

template std::vector<NamedStress<2>> named_stresses(const fem::Solution<2>&);
template std::vector<NamedStress<3>> named_stresses(const fem::Solution<3>&);
template std::vector<ComparisonRow> strength_rows(const fem::Solution<2>&);
template std::vector<ComparisonRow> strength_rows(const fem::Solution<3>&);
template std::string strength_line(const fem::Solution<2>&);
template std::string strength_line(const fem::Solution<3>&);

}  // namespace geneva::post
