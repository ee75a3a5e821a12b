#pragma once

#include "loads/motion/jet.h"

namespace geneva::loads {

/// Laws of periodic motion (Kolomiets, Kandyak, Ternytskyi): progress A of a step against relative
/// time k, A(0) = 0, A(1) = 1.
enum class MotionLaw {
  cycloidal,  ///< A = k - sin(2 pi k)/(2 pi)
  harmonic    ///< A = (1 - cos(pi k))/2
};

/// A(k) with its derivatives with respect to k.
/// @param relative_time k in [0, 1]
/// @throws base::InputError outside [0, 1]
Jet progress(MotionLaw law, double relative_time);

/// The square root of A(k) with its derivatives, for k up to 1/2: smooth at k = 0 for the harmonic
/// law, sin(pi k/2); the cycloidal law's grows as k^(3/2), its second derivative is infinite there.
/// @throws base::InputError outside [0, 1/2]
Jet root_of_progress(MotionLaw law, double relative_time);

/// Whether the second derivative of the root is bounded.
bool has_smooth_root(MotionLaw law);

}  // namespace geneva::loads
