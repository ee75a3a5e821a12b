#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "api/analysis.h"

namespace geneva::api {

/// Two or three components as a vector of space; z is 0 in the plane.
template <std::size_t dim>
Vector vector_of(const std::array<double, dim>& components) {
  Vector vector{};
  std::copy(components.begin(), components.end(), vector.begin());
  return vector;
}

}  // namespace geneva::api
