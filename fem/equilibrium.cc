#include "fem/equilibrium.h"

#include <deal.II/lac/solver_control.h>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/errors.h"
#include "fem/conditioning.h"
#include "fem/contact/active_set.h"
#include "fem/elasticity/material_history.h"
#include "fem/rigid_balance.h"
#include "fem/rigid_motion.h"

namespace geneva::fem {

namespace {

template <int dim>
std::vector<NodeStatus> inherited_status(const ContactInterface<dim>& interface,
                                         const ContactResult<dim>& contact, const double length) {
  if constexpr (dim == 2)
    return inherited(interface, contact.intervals, length);
  else
    return inherited(interface, contact.nodes, length);
}

/// The first contact pair without an active node.
template <int dim>
std::optional<std::size_t> open_pair(const Level<dim>& level) {
  for (std::size_t i = 0; i < level.interfaces.size(); ++i) {
    const auto& status = level.interfaces[i].status;
    if (std::none_of(status.begin(), status.end(), is_closed)) return i;
  }
  return std::nullopt;
}

/// Whether a pair has friction that does not slide everywhere.
template <int dim>
bool may_stick(const Level<dim>& level) {
  return std::any_of(level.interfaces.begin(), level.interfaces.end(),
                     [](const ContactInterface<dim>& interface) { return interface.may_stick(); });
}

/// Of the pair whose friction would have to exceed its bound most [N]; nothing if none does, and
/// only the search for what sticks and slides went wrong.
template <int dim>
std::optional<Stop> sliding_stop(const Level<dim>& level, const LevelState& state,
                                 const Problem<dim>& problem, const Scales& scales) {
  Stop stop{Outcome::slides};
  for (std::size_t i = 0; i < level.interfaces.size(); ++i) {
    const ContactInterface<dim>& interface = level.interfaces[i];
    dealii::Tensor<1, dim> friction;
    double bound = 0.;
    for (std::size_t row = 0; row < interface.rows.size(); ++row) {
      const ContactRow<dim>& contact = interface.rows[row];
      bound +=
          contact.weight * problem.pairs[i].friction.coefficient * state.contacts[i].pressure[row];
      for (std::size_t t = 0; t < contact.frame.tangents.size(); ++t)
        friction += contact.weight * state.contacts[i].friction[row][t] * contact.frame.tangents[t];
    }
    const double force = scales.stress * scales.length * scales.length;
    if (force * (friction.norm() - bound) <= stop.needed - stop.limit) continue;
    stop.needed = force * friction.norm();
    stop.limit = force * bound;
    stop.pair = i;
  }
  if (stop.needed <= stop.limit) return std::nullopt;
  return stop;
}

}  // namespace

Solved with_fallback(const Settings& settings,
                     const std::function<Solved(const Settings&)>& solve) {
  Solved result = solve(settings);
  const auto* const stop = std::get_if<Stop>(&result);
  if (stop == nullptr || stop->outcome != Outcome::linear_solver ||
      settings.linear_solver != LinearSolver::automatic)
    return result;
  Settings by_library = settings;
  by_library.linear_solver = LinearSolver::library;
  return solve(by_library);
}

template <int dim>
Equilibrium<dim>::Equilibrium(const MPI_Comm communicator, const mesh::MeshData<dim>& mesh,
                              const Problem<dim>& problem, const Scales& scales)
    : communicator_(communicator),
      coarse_(mesh),
      problem_(problem),
      scaled_problem_(scaled(problem, scales)),
      scales_(scales),
      mesh_(communicator, mesh, scales.length) {
  make_level({});
  check_rigid_motions(level_, problem_);
  is_held_by_friction_ =
      may_stick(level_) && has_free_motion(level_, problem_, TakenAsClosed::all_nodes_sliding);
  for (const ContactInterface<dim>& interface : level_.interfaces) {
    holds_by_friction_.push_back(is_held_by_friction_ &&
                                 is_held_by_friction(level_, problem_, interface));
    holds_by_contact_.push_back(is_held_by_contact(level_, problem_, interface));
  }
  tell_what_holds();
  check_approach(level_, scaled_problem_, scales_, communicator_);
  check_that_loads_close();
}

template <int dim>
void Equilibrium<dim>::make_level(const State<dim>& state) {
  n_unknowns_ = mesh_.dof_handler->n_dofs();
  load_ = {};
  level_ = fem::make_level(*mesh_.dof_handler, coarse_, scaled_problem_, scales_, origins_);
  for (std::size_t i = 0; i < state.contacts.size(); ++i)
    level_.interfaces[i].status =
        inherited_status(level_.interfaces[i], state.contacts[i], scales_.length);
  tell_what_holds();
  set_smooth(state.smooth);
}

template <int dim>
void Equilibrium<dim>::tell_what_holds() {
  level_.is_held_by_friction = is_held_by_friction_;
  level_.holds_by_friction = holds_by_friction_;
  level_.holds_by_contact = holds_by_contact_;
}

template <int dim>
void Equilibrium<dim>::set_load(const Load& load) {
  if (load == load_) return;
  fem::set_load(level_, *mesh_.dof_handler, coarse_, at_instant(scaled_problem_, load));
  load_ = load;
}

template <int dim>
void Equilibrium<dim>::set_smooth(const std::vector<ArcIntervals>& smooth) {
  for (std::size_t i = 0; i < smooth.size(); ++i) level_.interfaces[i].smooth = smooth[i];
}

template <int dim>
void Equilibrium<dim>::touch_first() {
  for (ContactInterface<dim>& interface : level_.interfaces)
    interface.status = first_touch(interface);
}

template <int dim>
State<dim> Equilibrium<dim>::at_rest() const {
  return {Vector(level_.owned, communicator_), {}, {}, {}};
}

template <int dim>
Solved Equilibrium<dim>::advance(const State<dim>& from, const Load& load, const Settings& settings,
                                 const StepObserver& observer) {
  set_load(load);
  return with_fallback(settings,
                       [&](const Settings& chosen) { return solve(from, chosen, observer); });
}

template <int dim>
Solved Equilibrium<dim>::solve(const State<dim>& from, const Settings& settings,
                               const StepObserver& observer) {
  try {
    auto state = solve_level(*mesh_.dof_handler, level_, from.displacement, settings, observer);
    if (state && state->lifts_off) open_what_pulls(state->contacts);
    if (state && !state->slides) {
      const bool is_singular =
          is_held_by_friction_ && has_free_motion(level_, problem_, TakenAsClosed::active_nodes);
      if (is_singular || state->cycled) check_that_contact_holds();
      if (!is_singular) return std::move(*state);
    } else if (state) {
      if (const auto stop = sliding_stop(level_, *state, problem_, scales_)) return *stop;
    }
    check_that_contact_holds();
    return stop_at_limit(Outcome::active_set_limit, settings.max_active_set_steps + 1.,
                         settings.max_active_set_steps, n_unknowns_);
  } catch (const dealii::SolverControl::NoConvergence& failure) {
    check_that_contact_holds();
    Stop stop{Outcome::linear_solver};
    stop.needed = failure.last_step;
    stop.unknowns = n_unknowns_;
    stop.residual = failure.last_residual;
    return stop;
  }
}

/// Loads are known to open a contact before anything is solved: without it the system is singular,
/// and what the active set makes of that is chance.
/// @throws base::InputError if they do, and a body moves freely then
template <int dim>
void Equilibrium<dim>::check_that_loads_close() {
  for (ContactInterface<dim>& interface : level_.interfaces) {
    if (!is_pulled_apart(interface)) continue;
    const std::vector<NodeStatus> open(interface.status.size(), NodeStatus::open);
    const std::vector<NodeStatus> before = std::exchange(interface.status, open);
    check_that_contact_holds();
    interface.status = before;
  }
}

/// Opens the contacts that only a node holds which pulls.
/// @throws base::InputError since a body moves freely then
template <int dim>
void Equilibrium<dim>::open_what_pulls(const std::vector<ContactState>& contacts) {
  for (std::size_t i = 0; i < contacts.size(); ++i)
    for (std::size_t row = 0; row < contacts[i].pressure.size(); ++row)
      if (contacts[i].pressure[row] < 0.) level_.interfaces[i].status[row] = NodeStatus::open;
  check_that_contact_holds();
}

/// Where the search for what touches, sticks and slides went wrong, there may be nothing to find.
/// @throws base::InputError if a body moves freely since contacts have opened, or if no friction
/// within its bounds can balance the loads
template <int dim>
void Equilibrium<dim>::check_that_contact_holds() const {
  const auto open = open_pair(level_);
  const auto motion = is_held_by_friction_
                          ? unresisted_motion(*mesh_.dof_handler, level_, scaled_problem_)
                          : std::nullopt;
  if (motion && (motion->is_rotation || !open))
    throw base::InputError(fmt::format(
        "{} under the load, over what is left of its contact: {}; check the place and "
        "the direction of the load, or add a support",
        motion->what, motion->is_rotation ? "it tips or rolls" : "friction does not hold it"));
  if (open && has_free_motion(level_, problem_, TakenAsClosed::active_nodes))
    throw base::InputError(
        fmt::format("the load pulls contact pair {} apart, and nothing else holds the body; "
                    "check the direction of the load",
                    quoted(problem_.pairs[*open])));
}

template <int dim>
State<dim> Equilibrium<dim>::refine(const Vector& displacement, State<dim> now) {
  MeshFields carried = mesh_.refine({displacement, std::move(now.history)});
  now.displacement = std::move(carried.displacement);
  now.history = std::move(carried.history);
  make_level(now);
  return now;
}

template <int dim>
State<dim> Equilibrium<dim>::refine_as(const Checkpoint<dim>& checkpoint) {
  if (checkpoint.active.size() != problem_.pairs.size())
    throw base::InputError("the checkpoint does not fit this case: it has other contact pairs");
  State<dim> state{mesh_.refine_as(checkpoint.field), {}, {}, {}};
  origins_ = checkpoint.origins;
  make_level(state);
  for (std::size_t i = 0; i < checkpoint.active.size(); ++i)
    level_.interfaces[i].status = active_at(level_.interfaces[i], checkpoint.active[i]);
  return state;
}

template <int dim>
State<dim> Equilibrium<dim>::end_of_instant(State<dim> before, const LevelState& found) const {
  before.history = remembered(*mesh_.dof_handler, scaled_problem_, material_laws(scaled_problem_),
                              found.displacement, before.history);
  before.displacement = without_ghosts(found.displacement);
  return before;
}

template <int dim>
void Equilibrium<dim>::remember_slip(const LevelState& found) {
  for (std::size_t i = 0; i < level_.interfaces.size(); ++i)
    level_.interfaces[i].slip_before = found.contacts[i].slip;
}

template <int dim>
void Equilibrium<dim>::forget_slip() {
  for (ContactInterface<dim>& interface : level_.interfaces) interface.slip_before.clear();
}

template <int dim>
void Equilibrium<dim>::recall(const Instant<dim>& instant) {
  for (std::size_t i = 0; i < level_.interfaces.size(); ++i)
    fem::recall(level_.interfaces[i], instant.pairs[i].motions);
}

template <int dim>
Vector Equilibrium<dim>::ghosted(const Vector& displacement) const {
  return with_ghosts(displacement, level_.ghosts);
}

template class Equilibrium<2>;
template class Equilibrium<3>;

}  // namespace geneva::fem
