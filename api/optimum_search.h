#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "api/candidate.h"
#include "model/input/variation.h"

namespace geneva::api {

/// Looks for the free dimensions of a case with which its goal is least under its limits.
class OptimumSearch {
 public:
  /// Share of the way from the lower to the upper bound, of each free dimension.
  using Place = std::vector<double>;

  /// @param given with free dimensions; it must outlive the search
  /// @param slot_bottom tensile stress [Pa] of a case's wheel, or nothing where it has no part
  /// @param tell called now and then with the number of candidates so far; may be empty
  OptimumSearch(const Case& given, std::function<double(const Case&)> slot_bottom,
                std::function<void(int)> tell);

  /// The case with these values of its free dimensions.
  [[nodiscard]] Case case_with(const std::vector<std::string>& values) const;

  /// A free dimension there, as a case file would say it.
  [[nodiscard]] std::string text_at(const Place& place, std::size_t dimension) const;

  /// @throws base::InputError if there is no such mechanism
  [[nodiscard]] Candidate candidate(const Case& given) const;

  /// The best place, looked for from all over the bounds.
  /// @throws base::InputError if none keeps the limits
  Place best();

  /// Whether a dimension changes goal or limits from bound to bound; taken for granted where every
  /// candidate costs a run, or a bound is no mechanism.
  [[nodiscard]] bool has_effect(const Place& best, std::size_t dimension);

  /// Why what lies beside the best place along a dimension is no candidate; empty: it is one.
  [[nodiscard]] std::string refusal_beside(const Place& best, std::size_t dimension);

  /// What the candidates' pressures are by.
  [[nodiscard]] PressureBasis basis() const { return basis_; }

  /// How many candidates were worked out.
  [[nodiscard]] int trials() const { return trials_; }

 private:
  /// What is to be least, and by how much each limit is exceeded.
  struct Value {
    double goal;
    std::vector<double> excess;

    [[nodiscard]] double worst() const;
  };

  struct Found {
    Place place;
    Value value;
  };

  /// Nothing where there is no such mechanism.
  std::optional<Value> value(const Place& place);

  [[nodiscard]] Case case_at(const Place& place) const;
  [[noreturn]] void refuse_limits(const Found& nearest) const;

  /// Within the limits first, then by the goal; outside by the excess.
  static bool is_better(const Found& a, const Found& b);

  [[nodiscard]] std::vector<Place> start_places() const;

  /// By steps in directions all round, halved until none is better (V. Torczon 1997): where limits
  /// meet what can be drawn at all, COBYLA's linear models find no step.
  Found polished(Found best);

  /// By COBYLA from there. Where there is no mechanism it sees a wall of the steepest kind.
  Place refined(const Found& start);

  const model::OptimisationCase& wanted_;
  std::filesystem::path directory_;
  model::ParameterText text_;
  std::vector<model::Variation> variations_;
  std::function<double(const Case&)> slot_bottom_;
  std::function<void(int)> tell_;
  PressureBasis basis_;
  std::string refusal_;
  int trials_ = 0;
};

}  // namespace geneva::api
