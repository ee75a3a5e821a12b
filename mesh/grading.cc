#include "mesh/grading.h"

#include <cmath>

namespace geneva::mesh {

namespace {

/// Of the layers at the ends over that in the middle.
constexpr double thickness_at_ends = 0.5;
const double end_angle = std::acos(thickness_at_ends);

}  // namespace

double graded(const Grading& grading, const double even) {
  const double part = even / grading.half_length;
  if (std::abs(part) >= 1.) return even;
  return grading.half_length * std::sin(end_angle * part) / std::sin(end_angle);
}

double even(const Grading& grading, const double graded) {
  const double part = graded / grading.half_length;
  if (std::abs(part) >= 1.) return graded;
  return grading.half_length * std::asin(part * std::sin(end_angle)) / end_angle;
}

}  // namespace geneva::mesh
