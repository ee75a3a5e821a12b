#include "model/input/nearest_word.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <utility>

namespace geneva::model {

namespace {

char lower_case(char letter) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
}

/// Levenshtein's distance: insertions, deletions and replacements that turn one word into the
/// other.
std::size_t edit_distance(const std::string& first, const std::string& second) {
  std::vector<std::size_t> above(second.size() + 1);
  std::iota(above.begin(), above.end(), std::size_t{0});
  for (const char letter : first) {
    std::vector<std::size_t> row{above.front() + 1};
    for (std::size_t j = 0; j < second.size(); ++j) {
      const std::size_t change = lower_case(letter) == lower_case(second[j]) ? 0 : 1;
      row.push_back(std::min({above[j] + change, above[j + 1] + 1, row.back() + 1}));
    }
    above = std::move(row);
  }
  return above.back();
}

}  // namespace

std::optional<std::string> nearest_word(const std::string& word,
                                        const std::vector<std::string>& candidates) {
  constexpr std::size_t longest = 100;
  if (word.size() > longest) return std::nullopt;
  std::optional<std::string> nearest;
  std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance >= least) continue;
    least = distance;
    nearest = candidate;
  }
  return nearest;
}

}  // namespace geneva::model
