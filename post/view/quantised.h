#pragma once

#include <cstdint>
#include <vector>

namespace geneva::post {

/// Numbers as 65 535 equal steps from the minimum to the maximum; half the memory of single
/// precision, and finer than colours and eyes.
struct Quantised {
  float low;
  float high;
  std::vector<std::uint16_t> steps;  ///< from low; 65 535 stands for not a number
};
Quantised quantised(const std::vector<float>& values);
std::vector<float> restored(const Quantised& values);

}  // namespace geneva::post
