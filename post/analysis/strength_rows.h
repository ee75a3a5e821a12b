#pragma once

#include <string>
#include <vector>

#include "post/analysis/comparison_row.h"
#include "post/analysis/results.h"

namespace geneva::post {

/// A maximum stress of a body away from the contacts.
template <int dim>
struct NamedStress {
  std::string body;
  std::string name;  ///< "von Mises stress" or "tensile stress"
  fem::StressMaximum<dim> maximum;
  std::string where;       ///< in words, such as "bottom of the engaged slot"
  bool is_beside_contact;  ///< what is taken for the contact's own field decides on it
  bool is_bounded;         ///< false beside a place that is left out: it depends on how much of it
};

/// Two of every body that has places away from the contacts' own field.
template <int dim>
std::vector<NamedStress<dim>> named_stresses(const fem::Solution<dim>& solution);

/// The same beside nothing, for the closing table.
template <int dim>
std::vector<ComparisonRow> strength_rows(const fem::Solution<dim>& solution);

/// Where they are: a line for the terminal; empty if there are none.
template <int dim>
std::string strength_line(const fem::Solution<dim>& solution);

}  // namespace geneva::post
