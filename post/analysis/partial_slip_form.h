#pragma once

#include <optional>

#include "loads/partial_slip.h"
#include "post/analysis/results.h"

namespace geneva::post {

/// Cattaneo's and Mindlin's closed form beside a contact that sticks and slips.
template <int dim>
struct PartialSlipForm {
  loads::PartialSlip slip;
  double bound;                      ///< mu p0 [Pa]
  dealii::Tensor<1, dim> direction;  ///< unit vector along which friction drags the source

  /// Friction on the source along the direction [Pa].
  [[nodiscard]] double traction(const ContactAnalysis<dim>& analysis,
                                const fem::ContactNode<dim>& node) const;
};

/// @return nothing unless Hertz's line or circle describes the contact, both bodies give way alike
/// (Dundurs' beta 0), and the load steps press the pair first and then move it along one line while
/// the pressure stays
template <int dim>
std::optional<PartialSlipForm<dim>> partial_slip(const fem::Solution<dim>& solution,
                                                 std::size_t pair,
                                                 const ContactAnalysis<dim>& analysis);

}  // namespace geneva::post
