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

/// Insertions, deletions, replacements and exchanges of neighbours that turn one word into the
/// other (optimal string alignment).
std::size_t edit_distance(const std::string& first, const std::string& second) {
  const auto is_same = [&](const std::size_t i, const std::size_t j) {
    return lower_case(first[i]) == lower_case(second[j]);
  };
  std::vector<std::vector<std::size_t>> rows(first.size() + 1,
                                             std::vector<std::size_t>(second.size() + 1));
  std::iota(rows[0].begin(), rows[0].end(), std::size_t{0});
  for (std::size_t i = 0; i < first.size(); ++i) {
    rows[i + 1][0] = i + 1;
    for (std::size_t j = 0; j < second.size(); ++j) {
      const std::size_t change = is_same(i, j) ? 0 : 1;
      std::size_t& least = rows[i + 1][j + 1];
      least = std::min({rows[i][j] + change, rows[i][j + 1] + 1, rows[i + 1][j] + 1});
      if (i > 0 && j > 0 && is_same(i, j - 1) && is_same(i - 1, j))
        least = std::min(least, rows[i - 1][j - 1] + 1);
    }
  }
  return rows.back().back();
}

bool begins_with(const std::string& whole, const std::string& part) {
  return part.size() <= whole.size() &&
         std::equal(part.begin(), part.end(), whole.begin(), [](const char one, const char other) {
           return lower_case(one) == lower_case(other);
         });
}

std::optional<std::string> only_one_that_begins_with(const std::string& word,
                                                     const std::vector<std::string>& candidates) {
  constexpr std::size_t fewest_letters = 3;
  if (word.size() < fewest_letters) return std::nullopt;
  const auto begins = [&](const std::string& candidate) { return begins_with(candidate, word); };
  const auto found = std::find_if(candidates.begin(), candidates.end(), begins);
  if (found == candidates.end() || std::any_of(found + 1, candidates.end(), begins))
    return std::nullopt;
  return *found;
}

/// As a word of its own: "Slot clearance" for "Clearance".
std::optional<std::string> shortest_that_ends_with(const std::string& word,
                                                   const std::vector<std::string>& candidates) {
  constexpr std::size_t fewest_letters = 4;
  if (word.size() < fewest_letters) return std::nullopt;
  std::optional<std::string> shortest;
  for (const std::string& candidate : candidates)
    if (candidate.size() > word.size() &&
        begins_with(candidate.substr(candidate.size() - word.size() - 1), " " + word) &&
        (!shortest || candidate.size() < shortest->size()))
      shortest = candidate;
  return shortest;
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
  if (!nearest) nearest = only_one_that_begins_with(word, candidates);
  return nearest ? nearest : shortest_that_ends_with(word, candidates);
}

}  // namespace geneva::model
