#pragma once

#include <optional>
#include <string>
#include <vector>

namespace geneva::model {

/// The candidate that the word may be a misspelling of: least edits without regard to case, at most
/// a third of its letters; else the only one that begins with it, from three letters on; else the
/// shortest whose last words it is, from four letters on; nothing if there is none.
std::optional<std::string> nearest_word(const std::string& word,
                                        const std::vector<std::string>& candidates);

}  // namespace geneva::model
