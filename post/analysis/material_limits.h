#pragma once

#include <vector>

#include "loads/material_limits.h"
#include "post/analysis/results.h"

namespace geneva::post {

/// Of the bodies of a contact whose strengths are known, where its closed form is a line or a
/// circle; the layer of a hardened one grows thinner beside the contact as that widens.
/// @param friction mu of gross sliding, >= 0
template <int dim>
std::vector<loads::MaterialLimit> material_limits(const fem::Solution<dim>& solution,
                                                  const fem::ContactResult<dim>& contact,
                                                  const ContactAnalysis<dim>& analysis,
                                                  const loads::Allowables& allowed,
                                                  double friction);

/// Whether a body's maximum von Mises stress lies in its hardened layer below a contact.
template <int dim>
bool is_in_layer(const fem::Solution<dim>& solution, const Results<dim>& results,
                 const loads::Allowables& allowed, std::size_t body);

}  // namespace geneva::post
