#pragma once

#include <deal.II/lac/trilinos_vector.h>

#include <optional>
#include <utility>
#include <vector>

#include "fem/multigrid/node_matrix.h"

namespace geneva::fem {

/// The sum of a matrix and of one that corrects a few of its rows.
template <int n>
class CorrectedMatrix {
 public:
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  explicit CorrectedMatrix(NodeMatrix<n> matrix) : matrix_(std::move(matrix)) {}

  /// Puts another correction, of the same unknowns, in place of the one before.
  void correct(NodeMatrix<n> correction) { correction_.emplace(std::move(correction)); }

  [[nodiscard]] const NodeMatrix<n>& uncorrected() const { return matrix_; }

  /// A v
  void vmult(Vector& result, const Vector& vector) const {
    matrix_.vmult(result, vector);
    if (correction_) correction_->vmult_add(result, vector);
  }

  /// b - A v
  void residual(Vector& result, const Vector& vector, const Vector& right_hand_side) const {
    matrix_.residual(result, vector, right_hand_side);
    if (correction_) correction_->residual(result, vector, result);
  }

  /// In the order of this rank's unknowns.
  [[nodiscard]] std::vector<double> diagonal() const {
    std::vector<double> result = matrix_.diagonal();
    if (!correction_) return result;
    const std::vector<double> correction = correction_->diagonal();
    for (std::size_t i = 0; i < result.size(); ++i) result[i] += correction[i];
    return result;
  }

 private:
  NodeMatrix<n> matrix_;
  std::optional<NodeMatrix<n>> correction_;
};

}  // namespace geneva::fem
