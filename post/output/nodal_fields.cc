#include "post/output/nodal_fields.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <utility>

namespace geneva::post {

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

double first_principal(const std::array<double, 6>& stress) {
  Eigen::Matrix3d matrix;
  matrix << stress[0], stress[3], stress[5],  //
      stress[3], stress[1], stress[4],        //
      stress[5], stress[4], stress[2];
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>()
      .computeDirect(matrix, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

}  // namespace geneva::post
