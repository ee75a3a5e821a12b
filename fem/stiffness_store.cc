#include "fem/stiffness_store.h"

#include <utility>

namespace geneva::fem {

template <int dim>
void StiffnessStore<dim>::keep(const Cell& cell, dealii::FullMatrix<double> stiffness) {
  kept_.insert_or_assign(cell->id(), Kept{vertices_of(cell), std::move(stiffness)});
}

template <int dim>
std::optional<dealii::FullMatrix<double>> StiffnessStore<dim>::take(const Cell& cell) {
  if (kept_.empty()) return std::nullopt;
  const auto found = kept_.find(cell->id());
  if (found == kept_.end()) return std::nullopt;
  Kept kept = std::move(found->second);
  kept_.erase(found);
  if (kept.vertices != vertices_of(cell)) return std::nullopt;
  return std::move(kept.stiffness);
}

template <int dim>
typename StiffnessStore<dim>::Vertices StiffnessStore<dim>::vertices_of(const Cell& cell) {
  Vertices vertices;
  for (unsigned int i = 0; i < n_vertices; ++i) vertices[i] = cell->vertex(i);
  return vertices;
}

template class StiffnessStore<2>;
template class StiffnessStore<3>;

}  // namespace geneva::fem
