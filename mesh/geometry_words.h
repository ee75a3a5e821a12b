#pragma once

#include <string_view>

namespace geneva::mesh {

/// Whether a word is reserved in Gmsh's language for drawing, meshing or calculating.
bool is_command(std::string_view word);

/// Whether a word is not reserved but understood in certain places: options, fields, colours.
bool is_context_word(std::string_view word);

/// What a word would do that no geometry may; null for all others. Words of which nothing is known
/// are not among these, and refused all the same.
const char* harm_of(std::string_view word);

}  // namespace geneva::mesh
