#include "fem/stress_patch.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <utility>

#include "fem/elasticity/invariants.h"

namespace geneva::fem {

using dealii::Point;

namespace {

template <int dim>
double von_mises_of(const StressVector<dim>& stress) {
  return von_mises(principal_stresses(
      assembled_stress<dim>([&](const unsigned int component) { return stress[component]; })));
}

}  // namespace

template <int dim>
Sample<dim> mirrored(const Sample<dim>& sample, const Mirror& mirror) {
  constexpr std::array<std::pair<unsigned int, unsigned int>, 3> shears{{{0, 1}, {0, 2}, {1, 2}}};
  Sample<dim> image = sample;
  image.place[mirror.axis] = 2. * mirror.place - sample.place[mirror.axis];
  for (unsigned int i = 3; i < n_stress_components<dim>; ++i)
    if (shears[i - 3].first == mirror.axis || shears[i - 3].second == mirror.axis)
      image.stress[i] = -image.stress[i];
  return image;
}

template <int dim>
LinearStress<dim> fitted(const Point<dim>& place, const std::vector<Sample<dim>>& samples) {
  using Square = Eigen::Matrix<double, dim + 1, dim + 1>;
  constexpr double minimum_determinant = 1e-6;
  double size = 0.;
  for (const Sample<dim>& sample : samples) size = std::max(size, place.distance(sample.place));
  Square matrix = Square::Zero();
  LinearStress<dim> sums = LinearStress<dim>::Zero();
  for (const Sample<dim>& sample : samples) {
    Eigen::Matrix<double, dim + 1, 1> terms;
    terms[0] = 1.;
    for (unsigned int k = 0; k < dim; ++k) terms[k + 1] = (sample.place[k] - place[k]) / size;
    matrix += terms * terms.transpose();
    sums += terms * sample.stress.transpose();
  }
  // The determinant relative to that of the diagonal: of a body that is thin beside its cells'
  // length, too, the derivatives are found.
  const double scale = matrix.diagonal().prod();
  if (!(matrix.determinant() > minimum_determinant * scale)) {
    LinearStress<dim> mean = LinearStress<dim>::Zero();
    mean.row(0) = sums.row(0) / matrix(0, 0);
    return mean;
  }
  LinearStress<dim> result = matrix.inverse() * sums;
  result.bottomRows(dim) /= size;
  return result;
}

template <int dim>
StressVector<dim> doubt_of_linear(const StressVector<dim>& stress, const StressVector<dim>& mean,
                                  const double share_of_relative) {
  const StressVector<dim> difference = stress - mean;
  const double size = von_mises_of<dim>(stress);
  const double relative = size > 0. ? von_mises_of<dim>(difference) / size : 0.;
  return std::min(1., share_of_relative * relative) * difference;
}

template Sample<2> mirrored(const Sample<2>&, const Mirror&);
template LinearStress<2> fitted(const Point<2>&, const std::vector<Sample<2>>&);
template StressVector<2> doubt_of_linear<2>(const StressVector<2>&, const StressVector<2>&, double);
template Sample<3> mirrored(const Sample<3>&, const Mirror&);
template LinearStress<3> fitted(const Point<3>&, const std::vector<Sample<3>>&);
template StressVector<3> doubt_of_linear<3>(const StressVector<3>&, const StressVector<3>&, double);

}  // namespace geneva::fem
