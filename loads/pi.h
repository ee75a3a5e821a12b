#pragma once

namespace geneva::loads {

inline constexpr double pi = 3.14159265358979323846;
/// One degree [rad].
inline constexpr double degree = pi / 180.;

}  // namespace geneva::loads
