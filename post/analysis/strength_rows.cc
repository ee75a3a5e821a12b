#include "post/analysis/strength_rows.h"

#include <fmt/format.h>

#include <map>

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
std::string where(const fem::Solution<dim>& solution, const fem::StressMaximum<dim>& maximum) {
  if (maximum.surface < 0) return "inside";
  const std::string& surface = solution.mesh.surfaces[static_cast<std::size_t>(maximum.surface)];
  const auto drawn = drawn_places.find({surface, maximum.is_round});
  if (drawn != drawn_places.end()) return drawn->second;
  return surface.empty() ? "surface without a name" : surface;
}

}  // namespace

template <int dim>
std::vector<NamedStress<dim>> named_stresses(const fem::Solution<dim>& solution) {
  std::vector<NamedStress<dim>> result;
  for (std::size_t i = 0; i < solution.strength.size(); ++i) {
    const fem::BodyStrength<dim>& body = solution.strength[i];
    const std::string& name = solution.problem.bodies[i].name;
    if (body.von_mises.value > 0.)
      result.push_back({name, "von Mises stress", body.von_mises, where(solution, body.von_mises)});
    if (body.tensile.value > 0.)
      result.push_back({name, "tensile stress", body.tensile, where(solution, body.tensile)});
  }
  return result;
}

template <int dim>
std::vector<ComparisonRow> strength_rows(const fem::Solution<dim>& solution) {
  std::vector<ComparisonRow> rows;
  for (const NamedStress<dim>& stress : named_stresses(solution))
    rows.push_back({stress.name + ", " + stress.body, base::Dimension::stress, stress.maximum.value,
                    stress.maximum.total_error(), true, std::nullopt, std::nullopt});
  return rows;
}

template <int dim>
std::string strength_line(const fem::Solution<dim>& solution) {
  std::string line;
  for (const NamedStress<dim>& stress : named_stresses(solution))
    line += fmt::format("{}{} of '{}': {}", line.empty() ? "away from the contact: " : "; ",
                        stress.name, stress.body, stress.where);
  return line.empty() ? line : line + '\n';
}

template std::vector<NamedStress<2>> named_stresses(const fem::Solution<2>&);
template std::vector<NamedStress<3>> named_stresses(const fem::Solution<3>&);
template std::vector<ComparisonRow> strength_rows(const fem::Solution<2>&);
template std::vector<ComparisonRow> strength_rows(const fem::Solution<3>&);
template std::string strength_line(const fem::Solution<2>&);
template std::string strength_line(const fem::Solution<3>&);

}  // namespace geneva::post
