#include "api/optimisation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <nlopt.hpp>
#include <optional>
#include <vector>

#include "api/mechanism_picture.h"
#include "api/output_directory.h"
#include "api/version.h"
#include "base/errors.h"
#include "loads/motion/kinematics.h"
#include "loads/wheel/internal_outline.h"
#include "model/input/variation.h"
#include "model/mechanism_state.h"
#include "model/pin_in_space.h"

namespace geneva {

namespace {

using base::Dimension;
using Goal = model::OptimisationCase::Goal;
using Place = std::vector<double>;  ///< share of the way from the lower to the upper bound, each

/// What is known of a candidate; SI units.
struct Figures {
  double pressure;
  double pressure_of_cycle;
  std::optional<double> mass;         ///< of wheels that are drawn
  std::optional<double> root_stress;  ///< of pins with a root
  std::optional<double> slot_bottom;  ///< where it is wanted
};

std::optional<double> mass_of(const model::MechanismCase& mechanism,
                              const model::MechanismDynamics& dynamics) {
  if (!dynamics.wheel) return std::nullopt;
  struct Drawing {
    loads::Outline operator()(const loads::GenevaDimensions& wheel) const {
      return loads::wheel_outline(wheel);
    }
    loads::Outline operator()(const loads::InternalDimensions& wheel) const {
      return loads::internal_wheel_outline(wheel);
    }
  };
  return mechanism.wheel.density * dynamics.sizes.thickness *
         loads::area_moments(std::visit(Drawing(), *dynamics.wheel)).area;
}

Figures figures_of_candidate(const Case& given) {
  const model::MechanismCase& mechanism = *given.mechanism;
  const model::MechanismState state = model::mechanism_state(mechanism);
  const loads::PinContact contact = api::pin_contact(mechanism, state.sizes);
  const loads::Characteristics cycle = loads::characteristics(state.driven, state.train, contact);
  Figures figures{loads::hertz_pressure(contact, state.load.force), cycle.pressure.value,
                  mass_of(mechanism, state), std::nullopt, std::nullopt};
  if (const auto beam = model::pin_beam(mechanism, state.sizes))
    figures.root_stress =
        loads::beam_bending(*beam, std::max(cycle.force.value, cycle.braking_force.value))
            .root_stress;
  return figures;
}

const char* name_of(const Goal goal) {
  switch (goal) {
    case Goal::pressure:
      return model::names::peak_pressure;
    case Goal::mass:
      return model::names::wheel_mass;
    case Goal::slot_bottom:
      return model::names::slot_bottom;
    case Goal::pressure_of_cycle:
      break;
  }
  return model::names::peak_pressure_of_cycle;
}

std::optional<double> value_of(const Figures& figures, const Goal goal) {
  switch (goal) {
    case Goal::pressure:
      return figures.pressure;
    case Goal::mass:
      return figures.mass;
    case Goal::slot_bottom:
      return figures.slot_bottom;
    case Goal::pressure_of_cycle:
      break;
  }
  return figures.pressure_of_cycle;
}

constexpr const char* root_stress = "bending stress at the pin root";

/// A figure and the limit that it has.
struct Limited {
  const char* name;
  std::optional<double> value;
  double limit;

  /// 0 at the limit, positive beyond it.
  [[nodiscard]] double excess() const { return value ? *value / limit - 1. : 1.; }
};

std::vector<Limited> limits_of(const model::OptimisationCase& wanted, const Figures& figures) {
  std::vector<Limited> limits;
  const auto add = [&](const char* const name, const std::optional<double>& limit,
                       const std::optional<double>& value) {
    if (limit) limits.push_back({name, value, *limit});
  };
  add(name_of(Goal::pressure_of_cycle), wanted.largest_pressure, figures.pressure_of_cycle);
  add(name_of(Goal::mass), wanted.largest_mass, figures.mass);
  add(name_of(Goal::slot_bottom), wanted.largest_slot_bottom, figures.slot_bottom);
  add(root_stress, wanted.largest_root_stress, figures.root_stress);
  return limits;
}

/// What is to be least, and by how much the worst limit is exceeded.
struct Value {
  double goal;
  std::vector<double> excess;

  [[nodiscard]] double worst() const {
    double most = 0.;
    for (const double each : excess) most = std::max(most, each);
    return most;
  }
};

class Search {
 public:
  Search(const Case& given, const std::function<double(const Case&)>& slot_bottom)
      : wanted_(*given.optimisation),
        directory_(given.directory),
        text_(model::read_parameter_text(given.directory / "case.prm")),
        slot_bottom_(slot_bottom) {
    for (const model::FreeDimension& free : wanted_.free)
      variations_.push_back({free.section, free.name, {}});
  }

  /// The case with its free dimensions there.
  [[nodiscard]] Case case_at(const Place& place) const {
    std::vector<std::string> values;
    for (std::size_t i = 0; i < place.size(); ++i) values.push_back(text_at(place, i));
    return case_with(values);
  }

  /// The case with these values of its free dimensions.
  [[nodiscard]] Case case_with(const std::vector<std::string>& values) const {
    return model::case_of(model::varied(text_, variations_, values), directory_);
  }

  [[nodiscard]] std::string text_at(const Place& place, const std::size_t i) const {
    const model::FreeDimension& free = wanted_.free[i];
    return free.text(free.lower + place[i] * (free.upper - free.lower));
  }

  [[nodiscard]] Figures figures(const Case& candidate) const {
    Figures figures = figures_of_candidate(candidate);
    if (slot_bottom_) figures.slot_bottom = slot_bottom_(candidate);
    return figures;
  }

  /// Nothing where there is no such mechanism.
  std::optional<Value> value(const Place& place) {
    ++trials_;
    try {
      const Figures found = figures(case_at(place));
      const auto goal = value_of(found, wanted_.goal);
      if (!goal) throw base::InputError(fmt::format("the {} is not known", name_of(wanted_.goal)));
      Value result{*goal, {}};
      for (const Limited& limited : limits_of(wanted_, found))
        result.excess.push_back(limited.excess());
      return result;
    } catch (const base::InputError& error) {
      refusal_ = error.what();
      return std::nullopt;
    }
  }

  /// The best place, looked for from all over the bounds.
  /// @throws base::InputError if none keeps the limits
  Place best() {
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
    if (best.value.worst() > tolerance) refuse_limits(best);
    return best.place;
  }

  /// Whether a dimension changes goal or limits from bound to bound; taken for granted where every
  /// candidate costs a run, or a bound is no mechanism.
  [[nodiscard]] bool has_effect(const Place& best, const std::size_t dimension) {
    if (slot_bottom_) return true;
    Place lower = best;
    Place upper = best;
    lower[dimension] = 0.;
    upper[dimension] = 1.;
    const auto first = value(lower);
    const auto last = value(upper);
    return !first || !last || first->goal != last->goal || first->excess != last->excess;
  }

  [[nodiscard]] int trials() const { return trials_; }

  /// Relative: by so much a limit may be exceeded.
  static constexpr double tolerance = 1e-6;

 private:
  struct Found {
    Place place;
    Value value;
  };

  [[noreturn]] void refuse_limits(const Found& nearest) const {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < nearest.place.size(); ++i)
      words.push_back(wanted_.free[i].name + " " + text_at(nearest.place, i));
    const Figures known = figures(case_at(nearest.place));
    std::vector<std::string> exceeded;
    for (const Limited& limited : limits_of(wanted_, known))
      if (limited.excess() > tolerance)
        exceeded.push_back(
            fmt::format("the {} is {:.3g} % beyond it", limited.name, 100. * limited.excess()));
    throw base::InputError(
        fmt::format("no candidate keeps the limits; at {}, which comes nearest, {}",
                    fmt::join(words, ", "), fmt::join(exceeded, ", ")));
  }

  /// Within the limits first, then by the goal; outside by the excess.
  static bool is_better(const Found& a, const Found& b) {
    const double beyond_a = std::max(0., a.value.worst() - tolerance);
    const double beyond_b = std::max(0., b.value.worst() - tolerance);
    return beyond_a != beyond_b ? beyond_a < beyond_b : a.value.goal < b.value.goal;
  }

  [[nodiscard]] std::vector<Place> start_places() const {
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

  /// J. H. Halton (1960).
  static Place halton(const std::size_t index, const std::size_t n) {
    constexpr std::array<std::size_t, 6> primes{2, 3, 5, 7, 11, 13};
    Place place;
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

  /// By COBYLA from there. Where there is no mechanism it sees a wall of the steepest kind.
  Place refined(const Found& start) {
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

  const model::OptimisationCase& wanted_;
  std::filesystem::path directory_;
  model::ParameterText text_;
  std::vector<model::Variation> variations_;
  std::function<double(const Case&)> slot_bottom_;
  std::string refusal_;
  int trials_ = 0;
};

std::optional<Figures> figures_before(const Search& search, const Case& given) {
  try {
    return search.figures(given);
  } catch (const base::InputError&) {
    return std::nullopt;
  }
}

std::vector<post::OptimumFigure> report_figures(const model::OptimisationCase& wanted,
                                                const std::optional<Figures>& before,
                                                const Figures& after) {
  constexpr double near = 2e-3;
  std::vector<post::OptimumFigure> rows;
  const auto add = [&](const char* const name, const Dimension dimension, const auto& of,
                       const std::optional<double>& limit) {
    const std::optional<double> value = of(after);
    if (!value) return;
    rows.push_back({name, dimension, before ? of(*before) : std::nullopt, *value, limit,
                    limit && *value > (1. - near) * *limit, std::nullopt, std::nullopt});
  };
  using Optional = std::optional<double>;
  add(
      name_of(Goal::pressure), Dimension::stress,
      [](const Figures& f) { return Optional(f.pressure); }, std::nullopt);
  add(
      name_of(Goal::pressure_of_cycle), Dimension::stress,
      [](const Figures& f) { return Optional(f.pressure_of_cycle); }, wanted.largest_pressure);
  add(
      name_of(Goal::mass), Dimension::mass, [](const Figures& f) { return f.mass; },
      wanted.largest_mass);
  add(
      "bending stress at the pin root", Dimension::stress,
      [](const Figures& f) { return f.root_stress; }, wanted.largest_root_stress);
  add(
      name_of(Goal::slot_bottom), Dimension::stress, [](const Figures& f) { return f.slot_bottom; },
      wanted.largest_slot_bottom);
  return rows;
}

}  // namespace

bool wants_slot_bottom(const Case& given) {
  return given.optimisation &&
         (given.optimisation->goal == Goal::slot_bottom || given.optimisation->largest_slot_bottom);
}

Optimum optimise(const Case& given, const std::function<double(const Case&)>& slot_bottom) {
  if (!given.mechanism)
    model::refuse_model(given, "there is no mechanism", "geneva optimise", "mechanism");
  if (!given.optimisation)
    throw base::InputError(
        "the case leaves nothing free: give 'Free' in the subsection 'Optimisation', for example "
        "'set Free = Wheel diameter: 80 mm .. 160 mm'");
  const model::OptimisationCase& wanted = *given.optimisation;
  Search search(given, wants_slot_bottom(given) ? slot_bottom : nullptr);
  const Place best = search.best();
  Optimum optimum{given, given, {}};
  const model::ParameterText text = model::read_parameter_text(given.directory / "case.prm");
  post::OptimumReport& report = optimum.report;
  report.about = model::header_of(given);
  report.geneva_version = version;
  report.goal = name_of(wanted.goal);
  constexpr double on_bound = 1e-3;
  std::vector<std::string> values;
  for (std::size_t i = 0; i < best.size(); ++i) {
    const model::FreeDimension& free = wanted.free[i];
    const model::Assignment* const own = text.find(free.section, free.name);
    const bool has_effect = search.has_effect(best, i);
    const bool stays = !has_effect && own != nullptr;
    values.push_back(stays ? own->value : search.text_at(best, i));
    report.dimensions.push_back({free.name, own == nullptr ? "" : own->value, values.back(),
                                 !has_effect               ? ""
                                 : best[i] < on_bound      ? "lower"
                                 : best[i] > 1. - on_bound ? "upper"
                                                           : "",
                                 has_effect});
  }
  optimum.best = search.case_with(values);
  report.figures =
      report_figures(wanted, figures_before(search, given), search.figures(optimum.best));
  report.trials = search.trials();
  return optimum;
}

std::string table(const Optimum& optimum) {
  return post::optimum_table(optimum.report, optimum.given.units);
}

Written write(const Optimum& optimum, const std::filesystem::path& directory) {
  return api::write_results(
      directory, optimum.given, "optimum",
      {{"optimum.json", post::optimum_summary(optimum.report).dump(2) + "\n"},
       {"optimum.csv", post::optimum_csv(optimum.report, optimum.given.units)},
       {"optimum.prm", optimum.best.completed},
       {"mechanism.json", api::mechanism_text(*optimum.best.mechanism)}});
}

}  // namespace geneva
