#pragma once

#include <rapidcheck.h>

namespace geneva::loads::test {

/// A random number from low to high in steps of a millionth of the range; shrinks towards low.
inline double between(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1000001) * 1e-6;
}

inline int random_stations() { return *rc::gen::inRange(3, 25); }

}  // namespace geneva::loads::test
