#pragma once

namespace geneva::loads {

inline constexpr double pi = 3.14159265358979323846;

}  // namespace geneva::loads
