#pragma once

#include <optional>

#include "fem/stress_recovery.h"
#include "post/analysis/closed_form.h"

namespace geneva::post {

/// Root-mean-square difference of the nodal stress, in between interpolated, from McEwen's over
/// |x| < 2 b, z < 3 b, relative to p0 (Frobenius norm of the in-plane tensor).
struct FieldDifference {
  double source_body;
  double target_body;
};

/// Over all ranks; nothing unless the closed form is a line contact.
std::optional<FieldDifference> field_difference(const fem::Solution<2>& solution,
                                                const ClosedForm& form,
                                                const fem::NodalStress<2>& stress);

}  // namespace geneva::post
