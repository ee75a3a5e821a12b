#pragma once

#include <string>

#include "fem/problem/problem_check.h"

namespace geneva::model {

/// What is wrong with a problem, by the parameter of the case file that says it.
std::string message_of(const fem::ProblemError& error);

}  // namespace geneva::model
