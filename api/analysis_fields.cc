#include "api/analysis_fields.h"

#include <deal.II/base/geometry_info.h>
#include <deal.II/fe/fe_system.h>

#include <algorithm>
#include <array>
#include <map>

#include "api/analysis.h"
#include "api/analysis_state.h"
#include "fem/discretisation/round_cell.h"
#include "post/analysis/stress.h"

namespace geneva {

namespace {

/// xx, yy, zz, xy, yz, zx
std::array<double, 6> components_of(const fem::PlaneStress& stress) {
  return {stress.in_plane[0][0],
          stress.in_plane[1][1],
          stress.out_of_plane,
          stress.in_plane[0][1],
          0.,
          0.};
}
std::array<double, 6> components_of(const dealii::SymmetricTensor<2, 3>& stress) {
  return {stress[0][0], stress[1][1], stress[2][2], stress[0][1], stress[1][2], stress[2][0]};
}

/// A mean of nodes with these weights, which add up to 1.
template <std::size_t n>
std::array<double, n> mean(const std::vector<std::array<double, n>>& of,
                           const std::vector<std::size_t>& nodes,
                           const std::vector<double>& weights) {
  std::array<double, n> result{};
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t k = 0; k < n; ++k) result[k] += weights[i] * of[nodes[i]][k];
  return result;
}

/// Collects the nodes of one body after the other: stress jumps from body to body, and no node
/// belongs to two.
template <int dim>
class FieldCollector {
 public:
  FieldCollector(const fem::Solution<dim>& solution, const post::NodalStress<dim>& stress,
                 const bool is_rounded)
      : solution_(solution), stress_(stress), is_rounded_(is_rounded) {}

  Fields collect() {
    for (const auto& cell : solution_.dof_handler->active_cell_iterators())
      if (cell->is_locally_owned())
        add(cell,
            Cell(&*solution_.triangulation, cell->level(), cell->index(), &*stress_.dof_handler));
    return std::move(fields_);
  }

 private:
  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

  void add(const Cell& cell, const Cell& with_stress) {
    std::vector<std::size_t> nodes;
    for (const unsigned int vertex : cell->vertex_indices()) {
      const auto [known, is_new] =
          numbers_.try_emplace(cell->vertex_index(vertex), fields_.places.size());
      if (is_new) add_node(cell, with_stress, vertex);
      nodes.push_back(known->second);
    }
    const fem::RoundCell<dim> round(cell);
    if (is_rounded_ && round.is_round()) return add_parts(round, nodes, cell->material_id());
    fields_.cells.push_back(std::move(nodes));
    fields_.bodies.push_back(cell->material_id());
  }

  /// @param nodes at the cell's corners
  void add_parts(const fem::RoundCell<dim>& round, const std::vector<std::size_t>& nodes,
                 const unsigned int body) {
    std::map<fem::PartCorner, std::size_t> known;
    for (unsigned int vertex = 0; vertex < nodes.size(); ++vertex)
      known[round.at_vertex(vertex)] = nodes[vertex];
    for (const fem::PartCorner& first : round.first_corners()) {
      std::vector<std::size_t> of_part;
      for (unsigned int corner = 0; corner < nodes.size(); ++corner) {
        const fem::PartCorner at = round.corner_of_part(first, corner);
        const auto [found, is_new] = known.try_emplace(at, fields_.places.size());
        if (is_new) add_node_between(round, nodes, round.reference(at));
        of_part.push_back(found->second);
      }
      fields_.cells.push_back(std::move(of_part));
      fields_.bodies.push_back(body);
    }
  }

  /// On the round surface, or between it and the cell's corners, with what is between theirs.
  void add_node_between(const fem::RoundCell<dim>& round, const std::vector<std::size_t>& nodes,
                        const dealii::Point<dim>& reference) {
    std::vector<double> weights;
    for (unsigned int i = 0; i < nodes.size(); ++i)
      weights.push_back(dealii::GeometryInfo<dim>::d_linear_shape_function(reference, i));
    const dealii::Point<dim> there = round.place(reference);
    Vector place{};
    for (unsigned int i = 0; i < dim; ++i) place[i] = solution_.scales.length * there[i];
    fields_.places.push_back(place);
    fields_.displacements.push_back(mean(fields_.displacements, nodes, weights));
    const auto stress = mean(fields_.stress, nodes, weights);
    fields_.stress.push_back(stress);
    fields_.von_mises.push_back(post::von_mises(stress));
  }

  void add_node(const Cell& cell, const Cell& with_stress, const unsigned int vertex) {
    Vector place{};
    Vector displacement{};
    for (unsigned int i = 0; i < dim; ++i) {
      place[i] = solution_.scales.length * cell->vertex(vertex)[i];
      displacement[i] =
          solution_.scales.length * solution_.displacement[cell->vertex_dof_index(vertex, i)];
    }
    fields_.places.push_back(place);
    fields_.displacements.push_back(displacement);
    const auto stress = post::assembled_stress<dim>([&](const unsigned int component) {
      return stress_.values[with_stress->vertex_dof_index(vertex, component)];
    });
    fields_.stress.push_back(components_of(stress));
    fields_.von_mises.push_back(post::von_mises(post::principal_stresses(stress)));
  }

  const fem::Solution<dim>& solution_;
  const post::NodalStress<dim>& stress_;
  bool is_rounded_;
  std::map<unsigned int, std::size_t> numbers_;  ///< of the nodes, by the vertices' indices
  Fields fields_;
};

}  // namespace

namespace api {

template <int dim>
post::NodalFields fields_of(const fem::Solution<dim>& solution,
                            const post::NodalStress<dim>& stress) {
  return FieldCollector<dim>(solution, stress, false).collect();
}

template <int dim>
post::NodalFields rounded_fields_of(const fem::Solution<dim>& solution,
                                    const post::NodalStress<dim>& stress) {
  return FieldCollector<dim>(solution, stress, true).collect();
}

template post::NodalFields fields_of(const fem::Solution<2>&, const post::NodalStress<2>&);
template post::NodalFields fields_of(const fem::Solution<3>&, const post::NodalStress<3>&);
template post::NodalFields rounded_fields_of(const fem::Solution<2>&, const post::NodalStress<2>&);
template post::NodalFields rounded_fields_of(const fem::Solution<3>&, const post::NodalStress<3>&);

}  // namespace api

Fields fields(const Analysis& analysis) {
  return std::visit(
      [](const auto& analysed) {
        return api::fields_of(analysed.solution, analysed.results.nodal);
      },
      analysis.state->analysed);
}

}  // namespace geneva
