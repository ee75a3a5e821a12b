#pragma once

#include <functional>
#include <string>

namespace geneva::app {

/// A wrong case or a machine that cannot run it; a limit or an accuracy not reached; a bug.
enum ExitCode { wrong_input = 1, not_converged = 2, internal_error = 3 };

/// What is said of an error of the program: its version, the command, and where to report it.
/// @param about as below
std::string bug_report(const std::string& what, const std::string& about);

/// What a command returns or, if it throws, the exit code of that, after the user has been told
/// why.
/// @param about what was to be done, for the report of a bug: "run CASE"
/// @param fail tells the user; with several ranks it may end the others
int exit_code_of(const std::function<int()>& command, const std::string& about,
                 const std::function<void(int, const std::string&)>& fail);

/// Says why on standard error.
void say_failure(int code, const std::string& text);

/// Says what was thrown before the ranks know each other; to be called where it is caught.
/// @return the exit code of it
int exit_code_at_start();

}  // namespace geneva::app
