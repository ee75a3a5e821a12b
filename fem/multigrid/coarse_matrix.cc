#include "fem/multigrid/coarse_matrix.h"

#include <Epetra_Import.h>
#include <Epetra_Map.h>

#include <vector>

#include "fem/multigrid/block_matrix.h"

namespace geneva::fem {

namespace {

using Matrix = dealii::TrilinosWrappers::SparseMatrix;

/// Rows of a matrix at unknowns of other ranks, which these send.
Epetra_CrsMatrix rows_of_others(std::vector<int> unknowns, const Epetra_CrsMatrix& matrix) {
  const Epetra_Map map(-1, static_cast<int>(unknowns.size()), unknowns.data(), 0, matrix.Comm());
  Epetra_CrsMatrix result(Copy, map, 0);
  result.Import(matrix, Epetra_Import(map, matrix.RowMap()), Insert);
  result.FillComplete(matrix.DomainMap(), matrix.RangeMap());
  return result;
}

template <int dim>
void add_line(NodeRow<dim>& of_node, const unsigned int component, const Epetra_CrsMatrix& matrix,
              const int line) {
  constexpr int n = n_rigid_motions<dim>;
  int count = 0;
  double* values = nullptr;
  int* columns = nullptr;
  matrix.ExtractMyRowView(line, count, values, columns);
  for (int i = 0; i < count; ++i) {
    const int column = matrix.GCID(columns[i]);
    of_node.at(column / n)(component, column % n) = values[i];
  }
}

template <int dim>
std::vector<NodeRow<dim>> rows_of_nodes(const CoupledNodes<dim>& nodes,
                                        const Epetra_CrsMatrix& prolongation) {
  std::vector<NodeRow<dim>> result(nodes.n_all());
  for (int line = 0; line < prolongation.NumMyRows(); ++line)
    add_line<dim>(result[static_cast<std::size_t>(line / dim)],
                  static_cast<unsigned int>(line % dim), prolongation, line);
  std::vector<int> numbers;
  for (std::size_t node = nodes.n_own(); node < nodes.n_all(); ++node)
    for (int component = 0; component < dim; ++component)
      numbers.push_back(nodes.unknown(node, component));
  const Epetra_CrsMatrix of_others = rows_of_others(numbers, prolongation);
  int line = 0;
  for (std::size_t node = nodes.n_own(); node < nodes.n_all(); ++node)
    for (unsigned int component = 0; component < dim; ++component)
      add_line<dim>(result[node], component, of_others, line++);
  return result;
}

/// A P at one node.
template <int dim>
NodeRow<dim> product_row(const std::size_t node, const CoupledNodes<dim>& nodes,
                         const std::vector<NodeRow<dim>>& prolongation) {
  NodeRow<dim> result;
  nodes.visit_row(node, [&](const std::size_t other, const auto& entries) {
    const NodeRow<dim>& row = prolongation[other];
    for (std::size_t i = 0; i < row.size(); ++i)
      result.at(row.number(i)).noalias() += entries * row.block(i);
  });
  return result;
}

template <int dim>
BlockRows<RigidMotion<dim>> product(const CoupledNodes<dim>& nodes,
                                    const std::vector<NodeRow<dim>>& prolongation) {
  BlockRows<RigidMotion<dim>> result;
  for (std::size_t node = 0; node < nodes.n_own(); ++node) {
    const NodeRow<dim>& left = prolongation[node];
    if (left.size() == 0) continue;
    const NodeRow<dim> right = product_row(node, nodes, prolongation);
    for (std::size_t i = 0; i < left.size(); ++i) {
      auto& row = result[left.number(i)];
      for (std::size_t j = 0; j < right.size(); ++j)
        row.at(right.number(j)).noalias() += left.block(i).transpose() * right.block(j);
    }
  }
  return result;
}

}  // namespace

template <int dim>
std::unique_ptr<Epetra_CrsMatrix> coarse_matrix(const CoupledNodes<dim>& nodes,
                                                const Matrix& prolongation) {
  return block_matrix(product(nodes, rows_of_nodes(nodes, prolongation.trilinos_matrix())),
                      prolongation.trilinos_matrix().DomainMap(),
                      prolongation.get_mpi_communicator());
}

template std::unique_ptr<Epetra_CrsMatrix> coarse_matrix(const CoupledNodes<2>&, const Matrix&);
template std::unique_ptr<Epetra_CrsMatrix> coarse_matrix(const CoupledNodes<3>&, const Matrix&);

}  // namespace geneva::fem
