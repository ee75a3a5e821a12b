#pragma once

#include <stdexcept>

namespace geneva::base {

/// What the user can mend: in the case, in the command, or on the machine (a full disk).
class InputError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// A limit that the case sets, of time or memory, was met where there is no result yet to keep.
class LimitReached : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace geneva::base
