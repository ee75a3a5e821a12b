#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "loads/motion/jet.h"

namespace geneva::loads::test {

/// Central difference of sixth order.
inline double difference(const std::function<double(double)>& f, double x, double h) {
  return (f(x + 3. * h) - f(x - 3. * h) - 9. * (f(x + 2. * h) - f(x - 2. * h)) +
          45. * (f(x + h) - f(x - h))) /
         (60. * h);
}

/// Expects each derivative of a jet to be the difference of the one before, to 1e-7 of the greater
/// of the derivative and of what the function's values and the scale of its argument allow.
inline void expect_consistent(const std::function<Jet(double)>& f, double x, double scale,
                              const std::string& what) {
  const Jet at = f(x);
  const double h = 4e-3 * scale;
  const auto near = [](double derivative, double found, double size, const std::string& text) {
    EXPECT_NEAR(derivative, found, 1e-7 * (std::abs(derivative) + size)) << text;
  };
  near(at.first, difference([&](double t) { return f(t).value; }, x, h), std::abs(at.value) / scale,
       what + ", first derivative");
  near(at.second, difference([&](double t) { return f(t).first; }, x, h),
       std::abs(at.first) / scale, what + ", second derivative");
  near(at.third, difference([&](double t) { return f(t).second; }, x, h),
       std::abs(at.second) / scale, what + ", third derivative");
}

}  // namespace geneva::loads::test
