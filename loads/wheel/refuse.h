#pragma once

#include <fmt/format.h>

#include <stdexcept>

#include "base/errors.h"

namespace geneva::loads {

/// Throws std::invalid_argument with the formatted message.
template <typename... Values>
[[noreturn]] void refuse(fmt::format_string<Values...> message, Values... values) {
  throw base::InputError(fmt::format(message, values...));
}

inline double mm(double metres) { return 1e3 * metres; }

}  // namespace geneva::loads
