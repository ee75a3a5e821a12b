#pragma once

#include <vector>

#include "loads/pin/load_evenness.h"
#include "loads/pin/maximum_mean.h"
#include "post/analysis/contact_section.h"

namespace geneva::fem {
template <int dim>
struct Solution;
}

namespace geneva::post {

template <int dim>
struct Results;

/// @param sections by ascending z; beyond them there is no load
/// @param length [m], > 0
loads::MaximumMean maximum_mean_load(const std::vector<ContactSection>& sections, double length);

/// Of the leading contact.
/// @throws base::InputError if it carries nothing
loads::LoadEvenness load_evenness(const fem::Solution<3>& solution, const Results<3>& results);

}  // namespace geneva::post
