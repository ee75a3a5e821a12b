#pragma once

#include <vector>

#include "post/analysis/contact_section.h"

namespace geneva::fem {
template <int dim>
struct Solution;
}

namespace geneva::post {

template <int dim>
struct Results;

/// How evenly a pin carries its load along its length. The maximum line load is the maximum mean
/// over a twentieth of the length: at a sharp edge the line load itself has no bound.
struct LoadEvenness {
  double maximum;        ///< [N/m]
  double place;          ///< middle of that twentieth along z [m]
  double even;           ///< pin force over the length on which the surfaces face each other [N/m]
  double peak_pressure;  ///< [Pa]
  double middle_pressure;                ///< [Pa]
  bool is_bounded;                       ///< the pressure at the ends
  std::vector<ContactSection> sections;  ///< by ascending z

  /// 1 for an even load.
  [[nodiscard]] double ratio() const { return maximum / even; }
};

/// Maximum mean line load over a length.
struct MaximumMean {
  double value;  ///< [N/m]
  double place;  ///< middle of that length along z [m]
};

/// @param sections by ascending z; beyond them there is no load
/// @param length [m], > 0
MaximumMean maximum_mean_load(const std::vector<ContactSection>& sections, double length);

/// Of the leading contact.
/// @throws base::InputError if it carries nothing
LoadEvenness load_evenness(const fem::Solution<3>& solution, const Results<3>& results);

}  // namespace geneva::post
