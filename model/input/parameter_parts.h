#pragma once

#include <string>
#include <vector>

#include "model/input/parameters.h"

namespace geneva::model {

/// A whole number that may be left empty.
QuantityRule whole_or_nothing(double lower, double upper, const std::string& text);

/// Puts more parameters behind those that are there.
void append(std::vector<Parameter>& parameters, std::vector<Parameter> more);

/// Of a material of a case or of the collection.
std::vector<Parameter> elastic_parameters(const SectionPath& section);

/// Of a material of a case: by name, by value, or both.
std::vector<Parameter> material_parameters(const SectionPath& section);

}  // namespace geneva::model
