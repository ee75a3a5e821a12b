#include "fem/linear/multigrid/chebyshev.h"

#include <cmath>

namespace geneva::fem {

namespace {

template <typename Matrix>
std::vector<double> inverse_diagonal(const Matrix& matrix) {
  std::vector<double> result = matrix.diagonal();
  for (double& entry : result) entry = 1. / entry;
  return result;
}

/// factor D^-1 v
void scale(Vector& vector, const std::vector<double>& inverse_diagonal, const double factor) {
  double* const values = vector.begin();
  for (std::size_t i = 0; i < inverse_diagonal.size(); ++i)
    values[i] *= factor * inverse_diagonal[i];
}

}  // namespace

template <typename Matrix>
Chebyshev<Matrix>::Chebyshev(const Matrix& matrix, const double lowest, const double highest)
    : matrix_(matrix),
      inverse_diagonal_(inverse_diagonal(matrix)),
      centre_((highest + lowest) / 2.),
      half_width_((highest - lowest) / 2.) {}

template <typename Matrix>
void Chebyshev<Matrix>::solve(Vector& solution, const Vector& right_hand_side) const {
  Vector step(right_hand_side);
  scale(step, inverse_diagonal_, 1. / centre_);
  solution = step;
  take_second_step(solution, step, right_hand_side);
}

template <typename Matrix>
void Chebyshev<Matrix>::improve(Vector& solution, const Vector& right_hand_side) const {
  Vector step(right_hand_side);
  matrix_.residual(step, solution, right_hand_side);
  scale(step, inverse_diagonal_, 1. / centre_);
  solution += step;
  take_second_step(solution, step, right_hand_side);
}

template <typename Matrix>
void Chebyshev<Matrix>::take_second_step(Vector& solution, Vector& step,
                                         const Vector& right_hand_side) const {
  const double first_rho = half_width_ / centre_;
  const double rho = 1. / (2. / first_rho - first_rho);
  Vector residual(right_hand_side);
  matrix_.residual(residual, solution, right_hand_side);
  scale(residual, inverse_diagonal_, 2. * rho / half_width_);
  step.sadd(rho * first_rho, 1., residual);
  solution += step;
}

template <typename Matrix>
double largest_eigenvalue(const Matrix& matrix, const MPI_Comm communicator, Vector& vector) {
  constexpr int n_steps = 12;
  vector.reinit(matrix.unknowns().own(), communicator);
  for (const auto row : vector.locally_owned_elements())
    vector(row) = std::sin(static_cast<double>(row * row % 7919));
  vector.compress(dealii::VectorOperation::insert);
  return largest_eigenvalue(matrix, vector, n_steps);
}

template <typename Matrix>
double largest_eigenvalue(const Matrix& matrix, Vector& vector, const int n_steps) {
  const std::vector<double> inverse = inverse_diagonal(matrix);
  Vector product(vector);
  for (int step = 0; step < n_steps; ++step) {
    vector /= vector.l2_norm();
    matrix.vmult(product, vector);
    scale(product, inverse, 1.);
    vector = product;
  }
  return vector.l2_norm();
}

template class Chebyshev<CondensedMatrix<2>>;
template class Chebyshev<CondensedMatrix<3>>;
template class Chebyshev<SymmetricMatrix<3>>;
template class Chebyshev<SymmetricMatrix<6>>;
#define INSTANTIATE(Matrix)                                             \
  template double largest_eigenvalue(const Matrix&, MPI_Comm, Vector&); \
  template double largest_eigenvalue(const Matrix&, Vector&, int);
INSTANTIATE(CondensedMatrix<2>)
INSTANTIATE(CondensedMatrix<3>)
INSTANTIATE(SymmetricMatrix<3>)
INSTANTIATE(SymmetricMatrix<6>)
#undef INSTANTIATE

}  // namespace geneva::fem
