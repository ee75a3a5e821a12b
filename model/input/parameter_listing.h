#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/input/parameters.h"

namespace geneva::model {

/// A parameter file with all parameters in their subsections, each with its explanation above it
/// and, where its value is another one or given, its default behind it.
/// @param value_of the parameter's value
/// @param is_given whether a case gives it, be it the default or not
std::string parameter_listing(const std::vector<Parameter>& parameters,
                              const std::function<std::string(const Parameter&)>& value_of,
                              const std::function<bool(const Parameter&)>& is_given);

}  // namespace geneva::model
