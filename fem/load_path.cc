#include "fem/load_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "base/errors.h"
#include "fem/contact/active_set.h"
#include "fem/energy_account.h"

namespace geneva::fem {

namespace {

/// @param before at the step before; nothing at the first one
template <int dim>
Instant<dim> instant_of(const Level<dim>& level, const LevelState& found, const Scales& scales,
                        const Instant<dim>* const before) {
  const double force = scales.stress * scales.length * scales.length;
  Instant<dim> instant;
  for (std::size_t i = 0; i < level.interfaces.size(); ++i) {
    const ContactInterface<dim>& interface = level.interfaces[i];
    const ContactState& state = found.contacts[i];
    PairAtInstant<dim> pair;
    if (before != nullptr) pair.dissipated = before->pairs[i].dissipated;
    for (std::size_t row = 0; row < interface.rows.size(); ++row) {
      const ContactRow<dim>& contact = interface.rows[row];
      const double share = contact.weight * force;
      if (interface.status[row] == NodeStatus::stick) ++pair.sticking;
      if (interface.status[row] == NodeStatus::slip) ++pair.slipping;
      for (unsigned int c = 0; c < dim; ++c)
        pair.force[c] += share * state.pressure[row] * contact.frame.normal[c];
      for (std::size_t t = 0; t < contact.frame.tangents.size(); ++t) {
        for (unsigned int c = 0; c < dim; ++c)
          pair.friction_force[c] += share * state.friction[row][t] * contact.frame.tangents[t][c];
        pair.dissipated -= share * scales.length * state.friction[row][t] *
                           (state.slip[row][t] - interface.slip_before_at(row)[t]);
      }
    }
    if (before != nullptr)  // no round-off where nothing slips
      pair.dissipated = std::max(pair.dissipated, before->pairs[i].dissipated);
    pair.dissipated = std::max(pair.dissipated, 0.);
    pair.motions = motions_of(interface);
    instant.pairs.push_back(std::move(pair));
  }
  return instant;
}

/// @throws base::InputError naming the step
template <int dim>
Solved advance(Equilibrium<dim>& equilibrium, const State<dim>& from, const Problem<dim>& problem,
               const std::size_t step, const Settings& settings, const StepObserver& observer) {
  if (problem.steps.empty()) return equilibrium.advance(from, {}, settings, observer);
  try {
    return equilibrium.advance(from, problem.steps[step], settings, observer);
  } catch (const base::InputError& error) {
    throw base::InputError(fmt::format("load step {}: {}", step + 1, error.what()));
  }
}

}  // namespace

template <int dim>
Solved walk(Equilibrium<dim>& equilibrium, const State<dim>& start, const Problem<dim>& problem,
            const Settings& settings, const StepObserver& observer, const StepWatch& watch,
            std::vector<Instant<dim>>& instants) {
  std::vector<Instant<dim>> found_here;
  equilibrium.forget_slip();
  const std::size_t n_steps = std::max<std::size_t>(problem.steps.size(), 1);
  State<dim> state{start.displacement, start.history, {}, {}};
  EnergyAccount<dim> energy;
  for (std::size_t step = 0;; ++step) {
    if (step < instants.size()) equilibrium.recall(instants[step]);
    Solved solved = advance(equilibrium, state, problem, step, settings, observer);
    if (auto* const stop = std::get_if<Stop>(&solved)) {
      stop->step = step;
      return solved;
    }
    const LevelState& found = std::get<LevelState>(solved);
    found_here.push_back(instant_of(equilibrium.level(), found, equilibrium.scales(),
                                    step == 0 ? nullptr : &found_here.back()));
    if (!problem.steps.empty())
      found_here.back().energy =
          energy.add(equilibrium.level(), found)
              .times(equilibrium.scales().force() * equilibrium.scales().length);
    if (watch) watch(step, found);
    if (step + 1 == n_steps) {
      instants = std::move(found_here);
      return solved;
    }
    equilibrium.remember_slip(found);
    state = equilibrium.end_of_instant(std::move(state), found);
  }
}

template Solved walk(Equilibrium<2>&, const State<2>&, const Problem<2>&, const Settings&,
                     const StepObserver&, const StepWatch&, std::vector<Instant<2>>&);
template Solved walk(Equilibrium<3>&, const State<3>&, const Problem<3>&, const Settings&,
                     const StepObserver&, const StepWatch&, std::vector<Instant<3>>&);

}  // namespace geneva::fem
