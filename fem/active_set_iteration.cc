#include "fem/active_set_iteration.h"

#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <type_traits>

#include "fem/contact/active_set.h"
#include "fem/contact/conditions.h"
#include "fem/contact/sliding_search.h"
#include "fem/holding_nodes.h"
#include "fem/linear/constraints.h"

namespace geneva::fem {

namespace {

template <int dim>
ActiveSets active_sets(const Level<dim>& level) {
  ActiveSets sets;
  for (const ContactInterface<dim>& interface : level.interfaces) sets.push_back(interface.status);
  return sets;
}

/// While the active set still moves, the residual need not be reduced further than this.
constexpr double loose_reduction = 0.02;

/// After so many steps whose sets still move the systems are solved to their tolerance: where one
/// body is a thousand times stiffer than the other, a reduced residual is still large beside the
/// pressure, and the sets would move for ever.
constexpr unsigned int most_loose_steps = 6;

/// Of what the law wants only nodes that close, or that begin to slip.
void only_close(const std::vector<NodeStatus>& now, std::vector<NodeStatus>& next) {
  for (std::size_t i = 0; i < next.size(); ++i) next[i] = std::max(next[i], now[i]);
}

/// The active sets seen on one mesh. A set that has been there before means cycling: from then on
/// nodes only close, or begin to slip, so that the iteration ends, and the next mesh starts from
/// there.
template <int dim>
class ActiveSetSearch {
 public:
  /// Takes over the next active sets.
  /// @param is_exact whether the system is solved to its tolerance: only then a contact may open
  /// wholly, since pressures of a system that has hardly been solved may all have the wrong sign
  /// @return whether they changed
  bool advance(Level<dim>& level, const std::vector<ContactState>& states, const bool is_exact) {
    constexpr double same_direction = 1e-6;
    const auto before = active_sets(level);
    seen_.insert(before);
    double turn = 0.;
    ActiveSets all_next;
    for (std::size_t i = 0; i < level.interfaces.size(); ++i) {
      all_next.push_back(updated(level.interfaces[i], states[i]));
      if (only_closes_) only_close(level.interfaces[i].status, all_next.back());
    }
    directions_.resize(level.interfaces.size());
    lifts_off_ = keep_one_closed(level, states, all_next);
    slides_ = level.is_held_by_friction && keep_one_stuck(level, states, all_next);
    for (std::size_t i = 0; i < level.interfaces.size(); ++i) {
      ContactInterface<dim>& interface = level.interfaces[i];
      const std::vector<NodeStatus>& next = all_next[i];
      if (!is_exact && std::none_of(next.begin(), next.end(), is_closed)) continue;
      auto sliding = next_sliding(interface, states[i]);
      if (interface.may_stick())
        turn = std::max(turn, directions_[i].advance(interface, states[i], next, sliding));
      interface.status = next;
      interface.sliding = sliding;
    }
    const auto after = active_sets(level);
    if (after == before) return turn > same_direction;
    if (seen_.count(after) > 0) only_closes_ = true;
    return true;
  }

  /// Forgets what was seen with loosely solved systems.
  void start_again() {
    for (auto& direction : directions_) direction.start_again();
    seen_.clear();
    only_closes_ = false;
  }

  [[nodiscard]] bool only_closes() const { return only_closes_; }
  /// Whether one node is kept from sliding, since nothing else would hold the bodies.
  [[nodiscard]] bool slides() const { return slides_; }
  /// Whether one node is kept from opening, since nothing else would hold the bodies.
  [[nodiscard]] bool lifts_off() const { return lifts_off_; }

 private:
  using Directions = std::conditional_t<dim == 3, SlidingSearch, NoSlidingSearch>;

  std::set<ActiveSets> seen_;
  std::vector<Directions> directions_;  ///< by interface
  bool only_closes_ = false;
  bool slides_ = false;
  bool lifts_off_ = false;
};

std::size_t n_active(const ActiveSets& sets) {
  std::size_t active = 0;
  for (const std::vector<NodeStatus>& set : sets)
    active += static_cast<std::size_t>(std::count_if(set.begin(), set.end(), is_closed));
  return active;
}

/// Number of nodes that differ over that of the active ones.
double changed_share(const ActiveSets& before, const ActiveSets& now) {
  std::size_t changed = 0;
  for (std::size_t i = 0; i < now.size(); ++i)
    for (std::size_t j = 0; j < now[i].size(); ++j)
      if (now[i][j] != before[i][j]) ++changed;
  return static_cast<double>(changed) /
         static_cast<double>(std::max<std::size_t>(n_active(now), 1));
}

/// The linear system of the active sets as they change.
template <int dim>
class SystemOfSets {
 public:
  SystemOfSets(const dealii::DoFHandler<dim>& dof_handler, const Settings& settings)
      : dof_handler_(dof_handler), settings_(settings) {}

  /// Goes over to the level's active sets.
  void update(const Level<dim>& level) {
    const ActiveSets sets = active_sets(level);
    is_smoothing_ = !level.is_factorised && n_smoothing_steps_ < most_smoothing_steps &&
                    n_active(sets) >= fewest_for_smoothing &&
                    (!system_ || changed_share(last_sets_, sets) > few_for_smoothing);
    if (is_smoothing_) ++n_smoothing_steps_;
    if (!system_) assemble(level);
    system_->constrain(constraints(level));
    if (!is_smoothing_ && !is_set_up_) set_up(method_for(level));
    last_sets_ = sets;
  }

  /// Whether the sets change by so much still that smoothing is enough.
  [[nodiscard]] bool is_smoothing() const { return is_smoothing_; }

  /// Solves, or smooths, the system of the sets of now.
  /// @param reduction of the residual that is enough; 0: to the settings' tolerance
  /// @return number of iterations
  /// @throws dealii::SolverControl::NoConvergence
  unsigned int solve(Vector& displacement, const double reduction) {
    return is_smoothing_ ? system_->smooth(displacement)
                         : system_->solve(displacement, settings_.linear_tolerance, reduction);
  }

  /// Time of the assembly and the preconditioner.
  [[nodiscard]] double assembly_seconds() const { return assembly_seconds_; }

 private:
  /// Share of the active nodes by which the sets change no more when smoothing is enough.
  static constexpr double few_for_smoothing = 0.05;
  static constexpr unsigned int most_smoothing_steps = 2;
  /// With fewer nodes the sets may change wholly from one mesh to the next.
  static constexpr std::size_t fewest_for_smoothing = 100;

  void assemble(const Level<dim>& level) {
    const dealii::Timer timer;
    system_.emplace(dof_handler_, level.ghosts, lasting_constraints(level), level.cells,
                    level.tie_forces);
    assembly_seconds_ = timer.wall_time();
  }

  [[nodiscard]] Method method_for(const Level<dim>& level) const {
    if (settings_.linear_solver == LinearSolver::library) return Method::library_multigrid;
    return level.is_factorised ? Method::factors : Method::multigrid;
  }

  void set_up(const Method method) {
    const dealii::Timer timer;
    system_->set_up(dof_handler_, method);
    is_set_up_ = true;
    assembly_seconds_ += timer.wall_time();
  }

  const dealii::DoFHandler<dim>& dof_handler_;
  const Settings& settings_;
  std::optional<LinearSystem<dim>> system_;
  ActiveSets last_sets_;
  unsigned int n_smoothing_steps_ = 0;
  bool is_smoothing_ = false;
  bool is_set_up_ = false;
  double assembly_seconds_ = 0.;
};

/// Evaluates the contacts.
template <int dim>
void evaluate_at(const Level<dim>& level, const Vector& displacement, LevelState& state) {
  state.displacement.copy_locally_owned_data_from(displacement);
  state.displacement.update_ghost_values();
  state.forces = surface_forces(level.forced, state.displacement);
  state.contacts.clear();
  for (const ContactInterface<dim>& interface : level.interfaces)
    state.contacts.push_back(evaluate(interface, state.displacement, state.forces, level.held));
}

/// Solves the system of the current active sets and evaluates the contacts.
template <int dim>
void solve_step(SystemOfSets<dim>& systems, const Level<dim>& level, const double reduction,
                Vector& displacement, LevelState& state) {
  state.linear_iterations.back() += systems.solve(displacement, reduction);
  evaluate_at(level, displacement, state);
}

}  // namespace

template <int dim>
LevelState state_at(const Level<dim>& level, const Vector& displacement) {
  LevelState state;
  state.displacement.reinit(level.owned, level.ghosts, displacement.get_mpi_communicator());
  evaluate_at(level, displacement, state);
  return state;
}

template <int dim>
std::optional<LevelState> solve_level(const dealii::DoFHandler<dim>& dof_handler, Level<dim>& level,
                                      const Vector& guess, const Settings& settings,
                                      const StepObserver& observer) {
  const MPI_Comm communicator = dof_handler.get_communicator();
  LevelState state;
  state.displacement.reinit(level.owned, level.ghosts, communicator);
  Vector displacement = guess;
  ActiveSetSearch<dim> search;
  SystemOfSets<dim> systems(dof_handler, settings);
  double reduction = loose_reduction;
  for (unsigned int step = 1; step <= settings.max_active_set_steps; ++step) {
    if (step > most_loose_steps && reduction > 0.) {
      reduction = 0.;
      search.start_again();
    }
    systems.update(level);
    const dealii::Timer solve_timer;
    state.linear_iterations.push_back(0);
    solve_step(systems, level, reduction, displacement, state);
    bool changed =
        search.advance(level, state.contacts, !systems.is_smoothing() && reduction == 0.);
    if (systems.is_smoothing()) {
      search.start_again();
      changed = true;
    } else if (!changed && reduction > 0.) {
      reduction = 0.;
      search.start_again();
      solve_step(systems, level, reduction, displacement, state);
      changed = search.advance(level, state.contacts, true);
    }
    state.assemble_and_solve_seconds = systems.assembly_seconds() + solve_timer.wall_time();
    observer(step, state.linear_iterations.back());
    state.cycled = search.only_closes();
    state.slides = search.slides();
    state.lifts_off = search.lifts_off();
    if (!changed) return state;
  }
  return std::nullopt;
}

template LevelState state_at(const Level<2>&, const Vector&);
template LevelState state_at(const Level<3>&, const Vector&);
template std::optional<LevelState> solve_level(const dealii::DoFHandler<2>&, Level<2>&,
                                               const Vector&, const Settings&, const StepObserver&);
template std::optional<LevelState> solve_level(const dealii::DoFHandler<3>&, Level<3>&,
                                               const Vector&, const Settings&, const StepObserver&);

}  // namespace geneva::fem
