#include "post/output/nodal_fields.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

namespace geneva::post {

namespace {

Eigen::Matrix3d matrix_of(const std::array<double, 6>& stress) {
  Eigen::Matrix3d matrix;
  matrix << stress[0], stress[3], stress[5],  //
      stress[3], stress[1], stress[4],        //
      stress[5], stress[4], stress[2];
  return matrix;
}

}  // namespace

std::vector<unsigned int> bodies_of_nodes(const NodalFields& fields) {
  std::vector<unsigned int> bodies(fields.places.size(), 0);
  for (std::size_t cell = 0; cell < fields.cells.size(); ++cell)
    for (const std::size_t node : fields.cells[cell]) bodies[node] = fields.bodies[cell];
  return bodies;
}

NodalFields mirrored(NodalFields fields) {
  for (auto& place : fields.places) place[1] = -place[1];
  for (auto& displacement : fields.displacements) displacement[1] = -displacement[1];
  for (auto& stress : fields.stress) {
    stress[3] = -stress[3];
    stress[4] = -stress[4];
  }
  for (std::vector<std::size_t>& cell : fields.cells)
    for (std::size_t corner = 0; corner < cell.size(); corner += 4) {
      std::swap(cell[corner], cell[corner + 2]);
      std::swap(cell[corner + 1], cell[corner + 3]);
    }
  return fields;
}

PrincipalRange principal_range(const std::array<double, 6>& stress) {
  const auto& [xx, yy, zz, xy, yz, zx] = stress;
  if (yz == 0. && zx == 0.) {  // in the plane, and around an axis
    const double middle = 0.5 * (xx + yy);
    const double shear = std::hypot(0.5 * (xx - yy), xy);
    return {std::max(middle + shear, zz), std::min(middle - shear, zz)};
  }
  const Eigen::Vector3d values = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>()
                                     .computeDirect(matrix_of(stress), Eigen::EigenvaluesOnly)
                                     .eigenvalues();
  return {values.maxCoeff(), values.minCoeff()};
}

double von_mises(const std::array<double, 6>& s) {
  const double normal =
      std::pow(s[0] - s[1], 2) + std::pow(s[1] - s[2], 2) + std::pow(s[2] - s[0], 2);
  return std::sqrt(0.5 * normal + 3. * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

/// Eigenvalues ascend.
std::array<double, 3> direction_of_first_principal(const std::array<double, 6>& stress) {
  const Eigen::Vector3d n =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix_of(stress)).eigenvectors().col(2);
  return {n(0), n(1), n(2)};
}

double along(const std::array<double, 3>& n, const std::array<double, 6>& stress) {
  const Eigen::Vector3d direction(n[0], n[1], n[2]);
  return direction.dot(matrix_of(stress) * direction);
}

}  // namespace geneva::post
