#include "api/optimum_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlopt.hpp>

#include "base/errors.h"

namespace geneva::api {

namespace {

/// Relative: by so much a limit may be exceeded.
constexpr double tolerance = 1e-6;

/// J. H. Halton (1960).
OptimumSearch::Place halton(const std::size_t index, const std::size_t n) {
  constexpr std::array<std::size_t, 6> primes{2, 3, 5, 7, 11, 13};
  OptimumSearch::Place place;
  for (std::size_t k = 0; k < n; ++k) {
    double value = 0.;
    double share = 1.;
    for (std::size_t rest = index; rest > 0; rest /= primes.at(k)) {
      share /= static_cast<double>(primes.at(k));
      value += share * static_cast<double>(rest % primes.at(k));
    }
    place.push_back(value);
  }
  return place;
}

/// Unit vectors: along the axes, and evenly between them.
std::vector<OptimumSearch::Place> directions_all_round(const std::size_t n) {
  std::vector<OptimumSearch::Place> directions;
  for (std::size_t k = 0; k < n; ++k)
    for (const double sign : {1., -1.}) {
      directions.emplace_back(n, 0.);
      directions.back()[k] = sign;
    }
  if (n == 1) return directions;
  constexpr std::size_t more = 16;
  for (std::size_t i = 1; i <= more; ++i) {
    OptimumSearch::Place direction = halton(i, n);
    double square = 0.;
    for (double& component : direction) {
      component = 2. * component - 1.;
      square += component * component;
    }
    if (square == 0.) continue;
    for (double& component : direction) component /= std::sqrt(square);
    directions.push_back(direction);
  }
  return directions;
}

}  // namespace

OptimumSearch::OptimumSearch(const Case& given, std::function<double(const Case&)> slot_bottom,
                             std::function<void(int)> tell)
    : wanted_(*given.optimisation),
      directory_(given.directory),
      text_(given.text),
      slot_bottom_(std::move(slot_bottom)),
      tell_(std::move(tell)),
      basis_(pressure_basis(given)) {
  text_.varied_by = "'Free'";
  for (const model::FreeDimension& free : wanted_.free)
    variations_.push_back({free.section, free.name, {}});
}

double OptimumSearch::Value::worst() const {
  double most = 0.;
  for (const double each : excess) most = std::max(most, each);
  return most;
}

Case OptimumSearch::case_at(const Place& place) const {
  std::vector<std::string> values;
  for (std::size_t i = 0; i < place.size(); ++i) values.push_back(text_at(place, i));
  return case_with(values);
}

Case OptimumSearch::case_with(const std::vector<std::string>& values) const {
  return model::case_of(model::varied(text_, variations_, values), directory_);
}

std::string OptimumSearch::text_at(const Place& place, const std::size_t i) const {
  const model::FreeDimension& free = wanted_.free[i];
  return free.text(free.lower + place[i] * (free.upper - free.lower));
}

Candidate OptimumSearch::candidate(const Case& given) const {
  Candidate candidate = candidate_of(given, basis_);
  if (slot_bottom_) candidate.slot_bottom = slot_bottom_(given);
  return candidate;
}

std::optional<OptimumSearch::Value> OptimumSearch::value(const Place& place) {
  constexpr int now_and_then = 20;
  if (tell_ && trials_ % now_and_then == 0) tell_(trials_);
  ++trials_;
  try {
    const Candidate found = candidate(case_at(place));
    const auto goal = value_of(found, wanted_.goal);
    if (!goal) throw base::InputError(fmt::format("the {} is not known", name_of(wanted_.goal)));
    Value result{*goal, {}};
    for (const LimitedFigure& limited : limited_figures(wanted_, found))
      result.excess.push_back(limited.excess());
    return result;
  } catch (const base::InputError& error) {
    refusal_ = error.what();
    return std::nullopt;
  }
}

OptimumSearch::Place OptimumSearch::best() {
  std::vector<Found> found;
  for (const Place& place : start_places())
    if (const auto here = value(place)) found.push_back({place, *here});
  if (found.empty()) throw base::InputError("no candidate can be worked out: " + refusal_);
  std::sort(found.begin(), found.end(), is_better);
  constexpr std::size_t starts = 3;
  Found best = found.front();
  for (std::size_t i = 0; i < std::min(starts, found.size()); ++i) {
    const Place place = refined(found[i]);
    const auto here = value(place);
    if (here && is_better({place, *here}, best)) best = {place, *here};
    if (slot_bottom_) break;  // every candidate costs a run
  }
  if (!slot_bottom_) best = polished(best);
  if (best.value.worst() > tolerance) refuse_limits(best);
  return best.place;
}

bool OptimumSearch::has_effect(const Place& best, const std::size_t dimension) {
  if (slot_bottom_) return true;
  Place lower = best;
  Place upper = best;
  lower[dimension] = 0.;
  upper[dimension] = 1.;
  const auto first = value(lower);
  const auto last = value(upper);
  return !first || !last || first->goal != last->goal || first->excess != last->excess;
}

std::string OptimumSearch::refusal_beside(const Place& best, const std::size_t dimension) {
  constexpr double beside = 1e-4;  // polished() comes nearer
  if (slot_bottom_) return "";
  for (const double step : {-beside, beside}) {
    Place place = best;
    place[dimension] = std::clamp(place[dimension] + step, 0., 1.);
    if (!value(place)) return refusal_;
  }
  return "";
}

void OptimumSearch::refuse_limits(const Found& nearest) const {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < nearest.place.size(); ++i)
    words.push_back(wanted_.free[i].name + " " + text_at(nearest.place, i));
  const Candidate known = candidate(case_at(nearest.place));
  std::vector<std::string> exceeded;
  for (const LimitedFigure& limited : limited_figures(wanted_, known))
    if (limited.excess() > tolerance)
      exceeded.push_back(
          fmt::format("the {} is {:.3g} % beyond it", limited.name, 100. * limited.excess()));
  throw base::InputError(
      fmt::format("no candidate keeps the limits; at {}, which comes nearest, {}",
                  fmt::join(words, ", "), fmt::join(exceeded, ", ")));
}

bool OptimumSearch::is_better(const Found& a, const Found& b) {
  const double beyond_a = std::max(0., a.value.worst() - tolerance);
  const double beyond_b = std::max(0., b.value.worst() - tolerance);
  return beyond_a != beyond_b ? beyond_a < beyond_b : a.value.goal < b.value.goal;
}

std::vector<OptimumSearch::Place> OptimumSearch::start_places() const {
  const std::size_t n = wanted_.free.size();
  const std::size_t steps = n == 1 ? (slot_bottom_ ? 12 : 64) : (slot_bottom_ ? 5 : 24);
  std::vector<Place> places;
  if (n <= 2) {
    for (std::size_t i = 0; i < (n == 1 ? steps : steps * steps); ++i) {
      Place place;
      for (std::size_t k = 0, rest = i; k < n; ++k, rest /= steps)
        place.push_back(static_cast<double>(rest % steps) / static_cast<double>(steps - 1));
      places.push_back(place);
    }
    return places;
  }
  const std::size_t many = slot_bottom_ ? 60 : 1500;
  for (std::size_t i = 1; i <= many; ++i) places.push_back(halton(i, n));
  return places;
}

OptimumSearch::Found OptimumSearch::polished(Found best) {
  constexpr double first_step = 0.05;
  constexpr double last_step = 1e-6;
  constexpr int most_moves = 20;  // with one step
  const std::vector<Place> directions = directions_all_round(best.place.size());
  double step = first_step;
  while (step > last_step) {
    bool has_moved = true;
    for (int move = 0; has_moved && move < most_moves; ++move) {
      has_moved = false;
      for (const Place& direction : directions) {
        Place place = best.place;
        for (std::size_t k = 0; k < place.size(); ++k)
          place[k] = std::clamp(place[k] + step * direction[k], 0., 1.);
        if (place == best.place) continue;
        const auto here = value(place);
        if (!here || !is_better({place, *here}, best)) continue;
        best = {place, *here};
        has_moved = true;
      }
    }
    step /= 2.;
  }
  return best;
}

OptimumSearch::Place OptimumSearch::refined(const Found& start) {
  const std::size_t n = wanted_.free.size();
  const std::size_t limits = start.value.excess.size();
  nlopt::opt search(nlopt::LN_COBYLA, static_cast<unsigned int>(n));
  std::optional<Place> known_place;
  Value known{};
  const auto at = [&](const Place& place) -> const Value& {
    if (known_place != place) {
      known =
          value(place).value_or(Value{1e3 * start.value.goal, std::vector<double>(limits, 1e3)});
      known_place = place;
    }
    return known;
  };
  struct Part {
    std::function<double(const Place&)> value;
    static double call(const Place& place, Place& /*gradient*/, void* const data) {
      return static_cast<Part*>(data)->value(place);
    }
  };
  Part goal{[&](const Place& place) { return at(place).goal / start.value.goal; }};
  std::vector<Part> constraints;
  for (std::size_t i = 0; i < limits; ++i)
    constraints.push_back({[&at, i](const Place& place) { return at(place).excess[i]; }});
  search.set_min_objective(&Part::call, &goal);
  for (Part& constraint : constraints)
    search.add_inequality_constraint(&Part::call, &constraint, 0.1 * tolerance);
  search.set_lower_bounds(0.);
  search.set_upper_bounds(1.);
  search.set_initial_step(0.02);
  search.set_xtol_abs(slot_bottom_ ? 2e-3 : 1e-7);
  search.set_maxeval(slot_bottom_ ? 40 : 1000);
  Place place = start.place;
  double least = 0.;
  try {
    search.optimize(place, least);
  } catch (const nlopt::roundoff_limited&) {  // as good as it gets
  }
  return place;
}

}  // namespace geneva::api
