#include "fem/linear/assembly.h"

#include <algorithm>
#include <map>
#include <utility>

#include "fem/linear/condensation.h"
#include "fem/linear/multigrid/block_rows.h"

namespace geneva::fem {

namespace {

using Constraints = dealii::AffineConstraints<double>;
using Dof = dealii::types::global_dof_index;

/// The cells' systems in the free unknowns, condensed each time they are visited (together they
/// would take as much memory as the matrix), and one system for each constrained unknown.
class CondensedSystems {
 public:
  CondensedSystems(const CellSystems& cells, const Constraints& constraints)
      : cells_(cells),
        constraints_(constraints),
        is_constrained_(cells.size(), false),
        free_unknowns_(cells.size()) {
    const auto is_constrained = [&](const Dof dof) { return constraints.is_constrained(dof); };
    std::map<Dof, double> diagonal;
    for (std::size_t index = 0; index < cells.size(); ++index) {
      const std::vector<Dof>& dofs = cells.dofs(index);
      is_constrained_[index] = std::any_of(dofs.begin(), dofs.end(), is_constrained);
      if (!is_constrained_[index]) continue;
      free_unknowns_[index] = free_unknowns(dofs, constraints);
      const dealii::FullMatrix<double> stiffness = cells.stiffness(index);
      for (unsigned int i = 0; i < dofs.size(); ++i)
        if (is_constrained(dofs[i])) diagonal[dofs[i]] += stiffness(i, i);
    }
    for (const auto& [dof, stiffness] : diagonal) {
      alone_.push_back({dealii::FullMatrix<double>(1), dealii::Vector<double>(1), {dof}});
      alone_.back().stiffness(0, 0) = stiffness;
    }
  }

  /// Calls visit(unknowns) for each system.
  template <typename Visit>
  void visit_unknowns(const Visit& visit) const {
    for (std::size_t index = 0; index < cells_.size(); ++index) visit(unknowns(index));
    for (const CellSystem& system : alone_) visit(system.dofs);
  }

  /// Calls visit(system) for each system of whose unknowns is_visited(unknowns), with the lines of
  /// the unknowns for which is_wanted(unknown) at least.
  template <typename IsVisited, typename IsWanted, typename Visit>
  void visit(const IsVisited& is_visited, const IsWanted& is_wanted, const Visit& visit) const {
    for (std::size_t index = 0; index < cells_.size(); ++index) {
      if (!is_visited(unknowns(index))) continue;
      if (is_constrained_[index])
        visit(condensed(cells_[index], constraints_, is_wanted));
      else
        visit(cells_[index]);
    }
    for (const CellSystem& system : alone_)
      if (is_visited(system.dofs)) visit(system);
  }

 private:
  [[nodiscard]] const std::vector<Dof>& unknowns(const std::size_t index) const {
    return is_constrained_[index] ? free_unknowns_[index] : cells_.dofs(index);
  }

  const CellSystems& cells_;
  const Constraints& constraints_;
  std::vector<bool> is_constrained_;
  std::vector<std::vector<Dof>> free_unknowns_;  ///< of cells with constraints
  std::vector<CellSystem> alone_;
};

/// The nodes of a system's unknowns, which follow each other node by node.
struct SystemNodes {
  std::vector<int> numbers;
  std::vector<unsigned int> first_unknowns;  ///< of each node, and the end
};

template <int dim>
SystemNodes nodes_of(const std::vector<Dof>& unknowns) {
  SystemNodes nodes;
  for (unsigned int i = 0; i < unknowns.size(); ++i) {
    const int number = static_cast<int>(unknowns[i]) / dim;
    if (!nodes.numbers.empty() && nodes.numbers.back() == number) continue;
    nodes.numbers.push_back(number);
    nodes.first_unknowns.push_back(i);
  }
  nodes.first_unknowns.push_back(static_cast<unsigned int>(unknowns.size()));
  return nodes;
}

/// Adds what a system has of a row's and a column's node.
/// @param row, column places of the nodes in nodes.numbers
template <int dim>
void add_block(const CellSystem& system, const SystemNodes& nodes, const std::size_t row,
               const std::size_t column, Eigen::Matrix<double, dim, dim>& block) {
  for (unsigned int i = nodes.first_unknowns[row]; i < nodes.first_unknowns[row + 1]; ++i)
    for (unsigned int j = nodes.first_unknowns[column]; j < nodes.first_unknowns[column + 1]; ++j)
      block(system.dofs[i] % dim, system.dofs[j] % dim) += system.stiffness(i, j);
}

template <int dim>
using Rows = BlockRows<Eigen::Matrix<double, dim, dim>>;

template <int dim>
void add_rows_of_others(const CellSystem& system, const OwnNodes& own, Rows<dim>& rows) {
  const SystemNodes nodes = nodes_of<dim>(system.dofs);
  for (std::size_t a = 0; a < nodes.numbers.size(); ++a) {
    if (own.have(nodes.numbers[a])) continue;
    auto& row = rows[nodes.numbers[a]];
    for (std::size_t b = 0; b < nodes.numbers.size(); ++b)
      add_block<dim>(system, nodes, a, b, row.at(nodes.numbers[b]));
  }
}

/// What the systems of other ranks add to rows of this one, for what its own add to theirs.
template <int dim>
Rows<dim> received_rows(const CondensedSystems& systems, const UnknownRanges& map,
                        const MPI_Comm communicator) {
  const OwnNodes own(map, dim);
  const auto is_of_other = [&](const Dof unknown) {
    return !own.have(static_cast<int>(unknown) / dim);
  };
  Rows<dim> rows;
  systems.visit(
      [&](const std::vector<Dof>& unknowns) {
        return std::any_of(unknowns.begin(), unknowns.end(), is_of_other);
      },
      is_of_other, [&](const CellSystem& system) { add_rows_of_others<dim>(system, own, rows); });
  send_to_owners(rows, own, map, communicator);
  return rows;
}

/// Of the systems and of what was received; each node is coupled to itself at least.
template <int dim>
NodePattern pattern_of(const CondensedSystems& systems, const Rows<dim>& received,
                       const UnknownRanges& map) {
  constexpr std::size_t usual_neighbours = dim == 2 ? 9 : 27;
  const OwnNodes own(map, dim);
  std::vector<std::vector<int>> coupled;
  for (int node = own.first; node < own.end; ++node) coupled.push_back({node});
  const auto list_of = [&](const int node) -> std::vector<int>& {
    return coupled[static_cast<std::size_t>(node - own.first)];
  };
  systems.visit_unknowns([&](const std::vector<Dof>& unknowns) {
    const SystemNodes nodes = nodes_of<dim>(unknowns);
    for (const int row : nodes.numbers) {
      if (!own.have(row)) continue;
      list_of(row).reserve(usual_neighbours);
      for (const int column : nodes.numbers) add_once(list_of(row), column);
    }
  });
  for (const auto& [node, row] : received)
    for (std::size_t i = 0; i < row.size(); ++i) add_once(list_of(node), row.number(i));
  return {map, dim, coupled};
}

/// Adds a system to the rows of this rank's nodes.
template <int dim>
void add(const CellSystem& system, SymmetricMatrix<dim>& matrix) {
  const NodePattern& pattern = matrix.pattern();
  const SystemNodes nodes = nodes_of<dim>(system.dofs);
  std::vector<int> places;
  for (const int node : nodes.numbers) places.push_back(pattern.place_of(node));
  for (std::size_t a = 0; a < places.size(); ++a) {
    if (!pattern.own().have(nodes.numbers[a])) continue;
    for (std::size_t b = 0; b < places.size(); ++b)
      if (places[b] >= places[a])
        add_block<dim>(system, nodes, a, b,
                       matrix.upper_block(static_cast<std::size_t>(places[a]), places[b]));
  }
}

}  // namespace

template <int dim>
SymmetricMatrix<dim> assemble(const CellSystems& cells, const Constraints& constraints,
                              const dealii::IndexSet& unknowns, const MPI_Comm communicator,
                              Vector& load) {
  const UnknownRanges map(static_cast<int>(unknowns.n_elements()), communicator);
  const CondensedSystems systems(cells, constraints);
  const Rows<dim> received = received_rows<dim>(systems, map, communicator);
  SymmetricMatrix<dim> matrix(pattern_of<dim>(systems, received, map));
  systems.visit([](const std::vector<Dof>&) { return true; },
                [&](const Dof unknown) { return unknowns.is_element(unknown); },
                [&](const CellSystem& system) {
                  add(system, matrix);
                  if (!system.load.all_zero()) load.add(system.dofs, system.load);
                });
  matrix.add(received);
  return matrix;
}

template SymmetricMatrix<2> assemble(const CellSystems&, const Constraints&,
                                     const dealii::IndexSet&, MPI_Comm, Vector&);
template SymmetricMatrix<3> assemble(const CellSystems&, const Constraints&,
                                     const dealii::IndexSet&, MPI_Comm, Vector&);

}  // namespace geneva::fem
