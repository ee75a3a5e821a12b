#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include "loads/pin/coupled_sections.h"

namespace geneva::loads {

/// Newton's iterations with an active set for the line loads q of coupled sections:
/// c + (K(q) + M) q - delta >= 0, q >= 0, and sum q h = F.
class SectionSearch {
 public:
  /// @param force F > 0 [N]
  /// @param start first guess of the loads, whose sum is scaled; some positive
  SectionSearch(CoupledSections& sections, double force, const Eigen::VectorXd& start);

  /// @throws base::InputError if it does not end
  void run();

  [[nodiscard]] const Eigen::VectorXd& loads() const { return loads_; }  ///< [N/m]
  [[nodiscard]] double approach() const { return approach_; }            ///< delta [m]

 private:
  double advance();
  void assemble();
  bool load_overlapping();

  CoupledSections& sections_;
  Eigen::Index n_;
  double force_;
  double mean_;
  Eigen::VectorXd loads_;
  Eigen::VectorXd displacements_;
  double approach_ = 0.;
  Eigen::MatrixXd system_;
  Eigen::VectorXd rest_;
  Eigen::VectorXd step_;
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

}  // namespace geneva::loads
