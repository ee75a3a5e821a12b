#include "mesh/grading.h"

#include <cmath>

namespace geneva::mesh {

namespace {

double alpha(const Grading& grading) {
  return std::acosh(1. / std::sqrt(grading.thickness_at_ends));
}

/// A map of [0, 1] on itself, continued oddly, and mirrored beyond the ends.
/// @param place over the half-length
template <typename Map>
double continued(const double place, const Map& map) {
  const double distance = std::abs(place);
  if (distance >= 2.) return place;
  return std::copysign(distance <= 1. ? map(distance) : 2. - map(2. - distance), place);
}

}  // namespace

double graded(const Grading& grading, const double even) {
  const double a = alpha(grading);
  return grading.half_length * continued(even / grading.half_length, [&](const double place) {
           return std::tanh(a * place) / std::tanh(a);
         });
}

double even(const Grading& grading, const double graded) {
  const double a = alpha(grading);
  return grading.half_length * continued(graded / grading.half_length, [&](const double place) {
           return std::atanh(place * std::tanh(a)) / a;
         });
}

}  // namespace geneva::mesh
