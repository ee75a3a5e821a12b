#include "fem/assembly.h"

#include <Epetra_CrsGraph.h>
#include <Epetra_CrsMatrix.h>

#include <Eigen/Core>
#include <algorithm>
#include <map>
#include <optional>

#include "fem/condensation.h"
#include "fem/multigrid/block_rows.h"

namespace geneva::fem {

namespace {

using Constraints = dealii::AffineConstraints<double>;
using Dof = dealii::types::global_dof_index;
using Matrix = dealii::TrilinosWrappers::SparseMatrix;
using Vector = dealii::TrilinosWrappers::MPI::Vector;

/// The cells' systems in the free unknowns, condensed each time they are visited (together they
/// would take as much memory as the matrix), and one system for each constrained unknown.
class CondensedSystems {
 public:
  CondensedSystems(const std::vector<CellSystem>& cells, const Constraints& constraints)
      : cells_(cells), constraints_(constraints), is_constrained_(cells.size(), false) {
    std::map<Dof, double> diagonal;
    for (std::size_t index = 0; index < cells.size(); ++index)
      for (unsigned int i = 0; i < cells[index].dofs.size(); ++i) {
        const Dof dof = cells[index].dofs[i];
        if (!constraints.is_constrained(dof)) continue;
        is_constrained_[index] = true;
        diagonal[dof] += cells[index].stiffness(i, i);
      }
    for (const auto& [dof, stiffness] : diagonal) {
      alone_.push_back({dealii::FullMatrix<double>(1), dealii::Vector<double>(1), {dof}});
      alone_.back().stiffness(0, 0) = stiffness;
    }
  }

  /// Calls visit(unknowns) for each system.
  template <typename Visit>
  void visit_unknowns(const Visit& visit) const {
    for (std::size_t index = 0; index < cells_.size(); ++index)
      if (is_constrained_[index])
        visit(free_unknowns(cells_[index].dofs, constraints_));
      else
        visit(cells_[index].dofs);
    for (const CellSystem& system : alone_) visit(system.dofs);
  }

  /// Calls visit(system) for each system of whose unknowns is_wanted(unknowns).
  template <typename IsWanted, typename Visit>
  void visit(const IsWanted& is_wanted, const Visit& visit) const {
    for (std::size_t index = 0; index < cells_.size(); ++index) {
      const CellSystem& cell = cells_[index];
      if (!is_constrained_[index]) {
        if (is_wanted(cell.dofs)) visit(cell);
      } else if (is_wanted(free_unknowns(cell.dofs, constraints_))) {
        visit(condensed(cell, constraints_));
      }
    }
    for (const CellSystem& system : alone_)
      if (is_wanted(system.dofs)) visit(system);
  }

 private:
  const std::vector<CellSystem>& cells_;
  const Constraints& constraints_;
  std::vector<bool> is_constrained_;
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

template <int dim>
using Rows = BlockRows<Eigen::Matrix<double, dim, dim>>;

template <int dim>
void add_rows_of_others(const CellSystem& system, const OwnNodes& own, Rows<dim>& rows) {
  const SystemNodes nodes = nodes_of<dim>(system.dofs);
  for (std::size_t a = 0; a < nodes.numbers.size(); ++a) {
    if (own.have(nodes.numbers[a])) continue;
    auto& row = rows[nodes.numbers[a]];
    for (std::size_t b = 0; b < nodes.numbers.size(); ++b) {
      auto& block = row.at(nodes.numbers[b]);
      for (unsigned int i = nodes.first_unknowns[a]; i < nodes.first_unknowns[a + 1]; ++i)
        for (unsigned int j = nodes.first_unknowns[b]; j < nodes.first_unknowns[b + 1]; ++j)
          block(system.dofs[i] % dim, system.dofs[j] % dim) += system.stiffness(i, j);
    }
  }
}

/// What the systems of other ranks add to rows of this one, for what its own add to theirs.
template <int dim>
Rows<dim> received_rows(const CondensedSystems& systems, const OwnNodes& own, const Epetra_Map& map,
                        const MPI_Comm communicator) {
  const auto has_others = [&](const std::vector<Dof>& unknowns) {
    return std::any_of(unknowns.begin(), unknowns.end(), [&](const Dof unknown) {
      return !own.have(static_cast<int>(unknown) / dim);
    });
  };
  Rows<dim> rows;
  systems.visit(has_others,
                [&](const CellSystem& system) { add_rows_of_others<dim>(system, own, rows); });
  send_to_owners(rows, own, map, communicator);
  return rows;
}

/// Nodes in the columns of each own node's rows, by their places.
struct Pattern {
  std::vector<std::vector<int>> places;
  ColumnNodes columns;
};

void add_once(std::vector<int>& list, const int number) {
  if (std::find(list.begin(), list.end(), number) == list.end()) list.push_back(number);
}

template <int dim>
Pattern pattern_of(const CondensedSystems& systems, const Rows<dim>& received,
                   const OwnNodes& own) {
  constexpr std::size_t usual_neighbours = dim == 2 ? 9 : 27;
  std::vector<std::vector<int>> lists(own.size());
  for (auto& list : lists) list.reserve(usual_neighbours);
  const auto list_of = [&](const int node) -> std::vector<int>& {
    return lists[static_cast<std::size_t>(node - own.first)];
  };
  systems.visit_unknowns([&](const std::vector<Dof>& unknowns) {
    const SystemNodes nodes = nodes_of<dim>(unknowns);
    for (const int row : nodes.numbers)
      if (own.have(row))
        for (const int column : nodes.numbers) add_once(list_of(row), column);
  });
  for (const auto& [node, row] : received)
    for (std::size_t i = 0; i < row.size(); ++i) add_once(list_of(node), row.number(i));
  std::vector<int> others;
  for (const auto& list : lists)
    std::copy_if(list.begin(), list.end(), std::back_inserter(others),
                 [&](const int node) { return !own.have(node); });
  Pattern pattern{std::move(lists), {own, std::move(others)}};
  for (auto& list : pattern.places) {
    for (int& number : list) number = pattern.columns.place_of(number);
    std::sort(list.begin(), list.end());
  }
  return pattern;
}

template <int dim>
Epetra_CrsGraph graph_of(const Pattern& pattern, const Epetra_Map& rows) {
  std::vector<int> lengths;
  lengths.reserve(dim * pattern.places.size());
  for (const auto& places : pattern.places)
    lengths.insert(lengths.end(), dim, dim * static_cast<int>(places.size()));
  Epetra_CrsGraph graph(Copy, rows, pattern.columns.unknowns(dim, rows.Comm()), lengths.data(),
                        true);
  std::vector<int> columns;
  int line = 0;
  for (const auto& places : pattern.places) {
    columns.clear();
    for (const int place : places)
      for (int component = 0; component < dim; ++component)
        columns.push_back(dim * place + component);
    for (int component = 0; component < dim; ++component)
      graph.InsertMyIndices(line++, static_cast<int>(columns.size()), columns.data());
  }
  graph.FillComplete(rows, rows);
  graph.OptimizeStorage();
  return graph;
}

/// A matrix of a pattern that values are added to.
template <int dim>
class NodeMatrix {
 public:
  NodeMatrix(const Epetra_CrsMatrix& matrix, const Pattern& pattern, const OwnNodes& own)
      : matrix_(matrix), pattern_(pattern), own_(own) {}

  void add(const CellSystem& system) const {
    const SystemNodes nodes = nodes_of<dim>(system.dofs);
    std::vector<int> places;
    for (const int node : nodes.numbers) places.push_back(pattern_.columns.place_of(node));
    std::vector<std::size_t> positions(places.size());
    for (std::size_t a = 0; a < places.size(); ++a) {
      if (!own_.have(nodes.numbers[a])) continue;
      for (std::size_t b = 0; b < places.size(); ++b)
        positions[b] = position(nodes.numbers[a], places[b]);
      for (unsigned int i = nodes.first_unknowns[a]; i < nodes.first_unknowns[a + 1]; ++i)
        add_line(system, i, nodes.first_unknowns, positions,
                 values_of(nodes.numbers[a], system.dofs[i] % dim));
    }
  }

  void add(const Rows<dim>& rows) const {
    for (const auto& [node, row] : rows)
      for (std::size_t i = 0; i < row.size(); ++i) {
        const std::size_t at = position(node, pattern_.columns.place_of(row.number(i)));
        for (unsigned int component = 0; component < dim; ++component)
          Eigen::Map<Eigen::Matrix<double, 1, dim>>(values_of(node, component) + at) +=
              row.block(i).row(component);
      }
  }

 private:
  /// @param positions of the blocks of the system's nodes in the values
  static void add_line(const CellSystem& system, const unsigned int line,
                       const std::vector<unsigned int>& first_unknowns,
                       const std::vector<std::size_t>& positions, double* const values) {
    for (std::size_t b = 0; b < positions.size(); ++b)
      for (unsigned int j = first_unknowns[b]; j < first_unknowns[b + 1]; ++j)
        values[positions[b] + system.dofs[j] % dim] += system.stiffness(line, j);
  }

  /// Of a node's block in the lines of an own node.
  [[nodiscard]] std::size_t position(const int node, const int place) const {
    const auto& places = pattern_.places[static_cast<std::size_t>(node - own_.first)];
    return dim * static_cast<std::size_t>(std::lower_bound(places.begin(), places.end(), place) -
                                          places.begin());
  }

  [[nodiscard]] double* values_of(const int node, const unsigned int component) const {
    int count = 0;
    double* values = nullptr;
    int* columns = nullptr;
    matrix_.ExtractMyRowView((node - own_.first) * dim + static_cast<int>(component), count, values,
                             columns);
    return values;
  }

  const Epetra_CrsMatrix& matrix_;
  const Pattern& pattern_;
  OwnNodes own_;
};

template <int dim>
void add(const CondensedSystems& systems, const NodeMatrix<dim>& sum, Vector& load) {
  systems.visit([](const auto&) { return true; },
                [&](const CellSystem& system) {
                  sum.add(system);
                  if (!system.load.all_zero()) load.add(system.dofs, system.load);
                });
}

}  // namespace

template <int dim>
void assemble(const std::vector<CellSystem>& cells, const Constraints& constraints,
              const dealii::IndexSet& unknowns, const MPI_Comm communicator, Matrix& matrix,
              Vector& load) {
  const Epetra_Map map = unknowns.make_trilinos_map(communicator, false);
  const OwnNodes own(map, dim);
  const CondensedSystems systems(cells, constraints);
  const Rows<dim> received = received_rows<dim>(systems, own, map, communicator);
  const Pattern pattern = pattern_of<dim>(systems, received, own);
  matrix.reinit(Epetra_CrsMatrix(View, graph_of<dim>(pattern, map)), false);
  const NodeMatrix<dim> sum(matrix.trilinos_matrix(), pattern, own);
  add(systems, sum, load);
  sum.add(received);
}

template void assemble<2>(const std::vector<CellSystem>&, const Constraints&,
                          const dealii::IndexSet&, MPI_Comm, Matrix&, Vector&);
template void assemble<3>(const std::vector<CellSystem>&, const Constraints&,
                          const dealii::IndexSet&, MPI_Comm, Matrix&, Vector&);

}  // namespace geneva::fem
