#pragma once

#include <rapidcheck.h>

namespace geneva::loads::test {

/// Uniform from low to high - 1 in every case: by itself the range would grow from case to case.
inline int uniform(int low, int high) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high));
}

/// A random number from low to high in steps of a millionth of the range; shrinks towards low.
inline double between(double low, double high) {
  return low + (high - low) * uniform(0, 1000001) * 1e-6;
}

inline int random_stations() { return uniform(3, 25); }

}  // namespace geneva::loads::test
