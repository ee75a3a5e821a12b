#include "fem/linear/condensation.h"

#include <algorithm>
#include <utility>

namespace geneva::fem {

namespace {

using dealii::types::global_dof_index;
using Constraints = dealii::AffineConstraints<double>;

/// LocalShares that an unknown has in free ones, by their places in the condensed system.
using LocalShares = std::vector<std::pair<unsigned int, double>>;

/// C by its rows.
std::vector<LocalShares> dependence(const std::vector<global_dof_index>& dofs,
                                    const std::vector<global_dof_index>& free,
                                    const Constraints& constraints) {
  const auto place_of = [&](const global_dof_index dof) {
    return static_cast<unsigned int>(std::lower_bound(free.begin(), free.end(), dof) -
                                     free.begin());
  };
  std::vector<LocalShares> result(dofs.size());
  for (std::size_t i = 0; i < dofs.size(); ++i)
    if (const auto* entries = constraints.get_constraint_entries(dofs[i]))
      for (const auto& [dof, weight] : *entries) result[i].emplace_back(place_of(dof), weight);
    else
      result[i].emplace_back(place_of(dofs[i]), 1.);
  return result;
}

/// The wanted lines of C^T K C.
dealii::FullMatrix<double> triple_product(const dealii::FullMatrix<double>& stiffness,
                                          const std::vector<LocalShares>& dependence,
                                          const std::vector<bool>& is_wanted) {
  const auto n_free = static_cast<unsigned int>(is_wanted.size());
  dealii::FullMatrix<double> left(n_free, stiffness.n());  // C^T K
  for (unsigned int i = 0; i < stiffness.m(); ++i)
    for (const auto& [place, weight] : dependence[i])
      if (is_wanted[place])
        for (unsigned int j = 0; j < stiffness.n(); ++j) left(place, j) += weight * stiffness(i, j);
  dealii::FullMatrix<double> result(n_free);
  for (unsigned int place = 0; place < n_free; ++place)
    if (is_wanted[place])
      for (unsigned int j = 0; j < stiffness.n(); ++j)
        for (const auto& [other, weight] : dependence[j])
          result(place, other) += left(place, j) * weight;
  return result;
}

}  // namespace

std::vector<global_dof_index> free_unknowns(const std::vector<global_dof_index>& unknowns,
                                            const Constraints& constraints) {
  std::vector<global_dof_index> free;
  for (const global_dof_index unknown : unknowns)
    if (const auto* entries = constraints.get_constraint_entries(unknown))
      for (const auto& entry : *entries) free.push_back(entry.first);
    else
      free.push_back(unknown);
  std::sort(free.begin(), free.end());
  free.erase(std::unique(free.begin(), free.end()), free.end());
  return free;
}

CellSystem condensed(const CellSystem& cell, const Constraints& constraints,
                     const std::function<bool(global_dof_index)>& is_wanted) {
  const auto free = free_unknowns(cell.dofs, constraints);
  const std::vector<LocalShares> shares = dependence(cell.dofs, free, constraints);
  dealii::Vector<double> prescribed(cell.load.size());  // g
  for (unsigned int i = 0; i < prescribed.size(); ++i)
    prescribed[i] = constraints.get_inhomogeneity(cell.dofs[i]);
  dealii::Vector<double> load(cell.load.size());  // f - K g
  cell.stiffness.vmult(load, prescribed);
  load.sadd(-1., cell.load);
  std::vector<bool> wanted(free.size());
  std::transform(free.begin(), free.end(), wanted.begin(), is_wanted);
  CellSystem result{triple_product(cell.stiffness, shares, wanted),
                    dealii::Vector<double>(static_cast<unsigned int>(free.size())), free};
  for (unsigned int i = 0; i < load.size(); ++i)
    for (const auto& [place, weight] : shares[i]) result.load[place] += weight * load[i];
  return result;
}

}  // namespace geneva::fem
