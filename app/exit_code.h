#pragma once

#include <functional>

namespace geneva::app {

/// A wrong case or a machine that cannot run it; a limit or an accuracy not reached; a bug.
enum ExitCode { wrong_input = 1, not_converged = 2, internal_error = 3 };

/// What a command returns or, if it throws, the exit code of that, after the first rank has said
/// why.
int exit_code_of(const std::function<int()>& command);

}  // namespace geneva::app
