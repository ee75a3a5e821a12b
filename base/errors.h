#pragma once

#include <stdexcept>

namespace geneva::base {

/// A limit that the case sets, of time or memory, was met where there is no result yet to keep.
class LimitReached : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace geneva::base
