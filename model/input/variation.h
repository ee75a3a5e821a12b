#pragma once

#include <string>
#include <vector>

#include "model/input/parameter_text.h"

namespace geneva::model {

/// A parameter and the values that it takes one after the other.
struct Variation {
  SectionPath section;
  std::string name;
  std::vector<std::string> values;  ///< as a case file would say them; one or more
};

/// Reads "Mechanism/Pin diameter = 8 mm .. 14 mm, 7", evenly from the first to the last value,
/// "... , 7, log", by equal ratios, or "Mechanism/Pin/Held at = one end; both ends".
/// @throws base::InputError with the text and what is wanted
Variation read_variation(const std::string& text);

/// Every combination of the variations' values, one of each; the last variation changes fastest.
/// @throws base::InputError if there are more than 100 000, or two variations are of one parameter
std::vector<std::vector<std::string>> combinations(const std::vector<Variation>& variations);

/// The text with the variations' parameters set to these values.
/// @param values one of each variation
ParameterText varied(ParameterText text, const std::vector<Variation>& variations,
                     const std::vector<std::string>& values);

}  // namespace geneva::model
