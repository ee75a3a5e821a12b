#include "fem/accuracy_loop.h"

#include <algorithm>
#include <new>
#include <utility>

#include "base/errors.h"
#include "fem/adaptivity/error_estimate.h"
#include "fem/adaptivity/stopping_rule.h"
#include "fem/contact/active_set.h"
#include "fem/contact/zone.h"
#include "fem/energy_error.h"
#include "fem/load_path.h"
#include "fem/mesh_result.h"

namespace geneva::fem {

namespace {

/// Whether a state follows from the load steps before it, and not from its displacement alone.
template <int dim>
bool remembers(const Level<dim>& level) {
  return std::any_of(level.interfaces.begin(), level.interfaces.end(),
                     [](const auto& interface) { return interface.may_stick(); });
}

/// Whether it is known how far the contact reaches along its length: in the plane it has none.
template <int dim>
bool knows_contact(const LevelRecord& now) {
  return dim == 2 || now.nodes_across >= nodes_for_grading;
}

}  // namespace

template <int dim>
AccuracyLoop<dim>::AccuracyLoop(const MPI_Comm communicator, const mesh::MeshData<dim>& mesh,
                                const Problem<dim>& problem, const Settings& settings,
                                const Progress<dim>& progress)
    : communicator_(communicator),
      settings_(settings),
      progress_(progress),
      limits_(communicator, settings),
      refinement_(mesh, problem, settings),
      strength_(mesh, problem, settings.structural_accuracy) {
  solution_.problem = problem;
  solution_.scales = scales_of(problem, mesh);
  solution_.mesh = mesh;
}

template <int dim>
Solution<dim> AccuracyLoop<dim>::run(const std::optional<Checkpoint<dim>>& start) {
  try {
    iterate(start);
  } catch (const std::bad_alloc&) {
    go_back_to_last_mesh();
  }
  return finish();
}

template <int dim>
void AccuracyLoop<dim>::iterate(const std::optional<Checkpoint<dim>>& start) {
  start_on_coarse_mesh();
  if (start) {
    restore(*start);
    if (!make_next_mesh()) return;
  }
  while (solve()) {
    record();
    if (!make_next_mesh()) return;
  }
}

template <int dim>
void AccuracyLoop<dim>::start_on_coarse_mesh() {
  equilibrium_.emplace(communicator_, solution_.mesh, solution_.problem, solution_.scales);
  solution_.triangulation = equilibrium_->mesh().triangulation;
  solution_.element = equilibrium_->mesh().element;
  solution_.dof_handler = equilibrium_->mesh().dof_handler;
  state_ = equilibrium_->at_rest();
}

/// @return false if no state was found: that of the last mesh then stands
template <int dim>
bool AccuracyLoop<dim>::solve() {
  while (advance()) {
    allocations_.require_none();
    if (!has_contact(solution_.problem) || n_active_nodes(equilibrium_->level()) > 0) {
      take_result();
      return true;
    }
    state_ = refinement_.refine_open_contact(*equilibrium_, *found_, std::move(state_),
                                             solution_.history, solution_.scales.length);
  }
  return false;
}

template <int dim>
bool AccuracyLoop<dim>::advance() {
  const auto tell = [&](const unsigned int step, const unsigned int iterations) {
    if (progress_.step)
      progress_.step({static_cast<unsigned int>(solution_.history.size()),
                      solution_.dof_handler->n_dofs(), step, iterations});
  };
  tell(0, 0);
  StepWatch watch;
  if (progress_.load_step)
    watch = [&](const std::size_t step, const LevelState& found) { tell_load_step(step, found); };
  auto result =
      walk(*equilibrium_, state_, solution_.problem, settings_, tell, watch, solution_.instants);
  if (auto* const found = std::get_if<LevelState>(&result)) {
    found_.emplace(std::move(*found));
    return true;
  }
  solution_.stop = std::get<Stop>(result);
  if (solution_.history.empty()) throw NotConverged(solution_.stop);
  return false;
}

template <int dim>
void AccuracyLoop<dim>::tell_load_step(const std::size_t step, const LevelState& found) {
  Solution<dim> at_step = solution_;
  at_step.strength.clear();  // these are of the mesh before
  at_step.singular.clear();
  at_step.instants.clear();
  put_result(at_step, equilibrium_->level(), found);
  progress_.load_step(step, at_step);
}

template <int dim>
void AccuracyLoop<dim>::take_result() {
  put_result(solution_, equilibrium_->level(), *found_);
  state_.contacts = solution_.contacts;
  is_ahead_ = false;
}

template <int dim>
void AccuracyLoop<dim>::tell(const Work work) {
  if (progress_.work) progress_.work({work, solution_.dof_handler->n_dofs()});
}

template <int dim>
void AccuracyLoop<dim>::find_smooth_parts() {
  if constexpr (dim == 2) {
    constexpr double share_of_accuracy = 0.1;
    state_.smooth.clear();
    for (std::size_t i = 0; i < found_->contacts.size(); ++i)
      state_.smooth.push_back(smooth_intervals(equilibrium_->level().interfaces[i],
                                               found_->contacts[i],
                                               share_of_accuracy * settings_.accuracy));
    equilibrium_->set_smooth(state_.smooth);
  }
}

template <int dim>
void AccuracyLoop<dim>::record() {
  tell(Work::stresses);
  find_smooth_parts();
  LevelRecord record = record_of(solution_, *equilibrium_, *found_, refinement_.surface_ids());
  refinement_.record(record);
  find_strength(solution_.history.size());
  record.strength = record_of(solution_.strength);
  if (force_follows_from_energy(solution_.problem))
    record.energy_error = energy_error(*solution_.dof_handler, solution_.displacement,
                                       solution_.problem, *strength_.stress());
  record.seconds = seconds_before_ + timer_.wall_time();
  solution_.history.push_back(record);
  estimate();
  if (progress_.level) progress_.level(solution_.history.back());
  if (progress_.solution) {
    tell(Work::figures);
    progress_.solution(solution_);
  }
  save();
}

/// @param meshes_before number of them in the history
template <int dim>
void AccuracyLoop<dim>::find_strength(const std::size_t meshes_before) {
  const auto begin = solution_.history.begin();
  solution_.strength =
      strength_.find(solution_, {begin, begin + static_cast<std::ptrdiff_t>(meshes_before)});
  solution_.singular = strength_.singular();
}

template <int dim>
void AccuracyLoop<dim>::estimate() {
  if (has_contact(solution_.problem)) return estimate_pressure();
  if (!is_stressed(solution_.strength))
    throw base::InputError(
        "no body has any stress: there is neither a load nor a support that moves; give 'Loads', "
        "'Body force', 'Gravity' or 'Angular speed'");
  solution_.error_estimate = maximum_error(solution_.strength);
  solution_.history.back().error_estimate = solution_.error_estimate;
}

template <int dim>
void AccuracyLoop<dim>::estimate_pressure() {
  const auto& interfaces = equilibrium_->level().interfaces;
  const bool is_on_axis = reaches_axis(solution_.problem, equilibrium_->level());
  const bool is_beside_end = peaks_beside_end(interfaces, found_->contacts);
  const bool is_line_contact = dim == 2 && solution_.problem.plane != PlaneKind::axisymmetric;
  solution_.has_free_ends = has_free_ends(interfaces);
  const bool is_freed_from_nodes = is_line_contact && solution_.has_free_ends && !is_beside_end &&
                                   !peaks_at_corner(solution_, equilibrium_->level(), *found_);
  const double of_ends = end_error(interfaces, found_->contacts, {is_on_axis, is_freed_from_nodes});
  const ForcePower force = force_follows_from_energy(solution_.problem)
                               ? force_of_peak({is_on_axis, is_beside_end, solution_.has_free_ends})
                               : ForcePower{};
  error_ = pressure_error<dim>(
      solution_.history,
      {{force_is_known(solution_.problem), is_on_axis, is_beside_end, dim == 2, is_freed_from_nodes,
        poissons_ratio_at_peak(solution_)},
       refinement_.grading(),
       error_of(of_ends, is_line_contact ? scatter_of_peak(solution_.contacts) : 0.),
       solution_.has_free_ends,
       refinement_.has_spread(equilibrium_->level()),
       refinement_.state().surroundings_are_fine,
       force});
  solution_.edge = error_.edge;
  solution_.correction = error_.correction;
  solution_.error_estimate = error_.total();
  solution_.history.back().error_estimate =
      error_.is_of_peak() ? error_.total() : std::min(1., 2. * error_.total());
  for (ContactResult<dim>& contact : solution_.contacts)
    contact.peak_pressure *= 1. + solution_.correction;
}

/// @return false if the refinement ends here
template <int dim>
bool AccuracyLoop<dim>::make_next_mesh() {
  std::optional<Stop> stop = choose_refinement();
  if (!stop) {
    tell(Work::refinement);
    strength_.forget_stress();
    state_ = refinement_.refine(*equilibrium_, *found_, std::move(state_), solution_.history);
    is_ahead_ = true;
    stop = limits_.exceeded_by(solution_.dof_handler->n_dofs());
    if (stop && contact_is_done_) stop = contact_is_done_;
  }
  if (stop) solution_.stop = *stop;
  return !stop;
}

/// Flags the cells that are worth refining.
/// @return why there is no next mesh, if there is none
template <int dim>
std::optional<Stop> AccuracyLoop<dim>::choose_refinement() {
  return has_contact(solution_.problem) ? choose_for_contact() : choose_for_strength();
}

template <int dim>
std::optional<Stop> AccuracyLoop<dim>::choose_for_strength() {
  if (solution_.error_estimate <= settings_.accuracy) return Stop{Outcome::converged};
  if (refinement_.state().n_refinements >= settings_.max_levels)
    return stop_at_limit(Outcome::refinement_limit, refinement_.state().n_refinements + 1.,
                         settings_.max_levels);
  const unsigned int flagged = strength_.flag(solution_, MeshFor::stresses);
  if (flagged == 0) return Stop{Outcome::no_progress};
  return limits_.exceeded_by_next(refinement_.choose_flagged(flagged, solution_.history),
                                  solution_.history, seconds_before_);
}

template <int dim>
std::optional<Stop> AccuracyLoop<dim>::choose_for_contact() {
  contact_is_done_.reset();
  const auto why = [&] {
    return why_to_stop(solution_.history,
                       {solution_.error_estimate, solution_.edge,
                        peaks_at_corner(solution_, equilibrium_->level(), *found_),
                        refinement_.state().n_refinements},
                       settings_);
  };
  if (const auto stop = why()) {
    if (!is_success(stop->outcome)) return stop;
    const auto growth = worth_refining_for_strength();
    if (!growth || limits_.exceeded_by_next(*growth, solution_.history, seconds_before_))
      return stop;
    contact_is_done_ = stop;
    return std::nullopt;
  }
  std::optional<double> growth = worth_refining();
  if (!growth) {  // only the zone's part of the error is left
    error_.surroundings = 0.;
    solution_.error_estimate = error_.zone;
    solution_.history.back().error_estimate = error_.zone;
    if (const auto stop = why()) return stop;
    growth = worth_refining();
  }
  // Else it is not known yet whether there is a contact.
  const LevelRecord& now = solution_.history.back();
  if (now.peak_pressure > 0. && !now.cycled) *growth += take_strength_along(*growth);
  return limits_.exceeded_by_next(*growth, solution_.history, seconds_before_);
}

/// Flags cells for the maxima of stress as well, unless a limit stands in their way alone.
/// @param growth of the number of cells by those for the contact
/// @return by how much more it grows
template <int dim>
double AccuracyLoop<dim>::take_strength_along(const double growth) {
  std::vector<bool> for_contact;
  for (const auto& cell : solution_.triangulation->active_cell_iterators())
    for_contact.push_back(cell->refine_flag_set());
  const unsigned int flagged = strength_.flag(
      solution_,
      knows_contact<dim>(solution_.history.back()) ? MeshFor::contact : MeshFor::unknown_contact);
  const double more = RefinementPass<dim>::growth_by_flagged(flagged, solution_.history);
  if (limits_.exceeded_by_next(growth + more, solution_.history, seconds_before_)) {
    for (const auto& cell : solution_.triangulation->active_cell_iterators())
      if (!for_contact[cell->active_cell_index()]) cell->clear_refine_flag();
    return 0.;
  }
  refinement_.take_along(flagged);
  return more;
}

template <int dim>
std::optional<double> AccuracyLoop<dim>::worth_refining() {
  return refinement_.choose(*equilibrium_, *found_, solution_.history, error_);
}

/// Where the contact is as accurate as asked, the cells that the maxima of stress away from it
/// need.
/// @return by what the number of cells grows; nothing if they need none
template <int dim>
std::optional<double> AccuracyLoop<dim>::worth_refining_for_strength() {
  constexpr std::ptrdiff_t most_passes = dim == 2 ? 6 : 2;  // each takes a solve
  const auto& history = solution_.history;
  const auto last_for_contact =
      std::find_if(history.rbegin(), history.rend(),
                   [](const LevelRecord& level) { return level.refined != Refined::nothing; });
  if (last_for_contact - history.rbegin() >= most_passes ||
      refinement_.state().n_refinements >= settings_.max_levels)
    return std::nullopt;
  const unsigned int flagged = strength_.flag(solution_, MeshFor::stresses);
  if (flagged == 0) return std::nullopt;
  return refinement_.choose_flagged(flagged, solution_.history);
}

/// Of one rank's memory the last mesh's state is kept, too, for when it runs out.
template <int dim>
void AccuracyLoop<dim>::save() {
  const bool is_alone = dealii::Utilities::MPI::n_mpi_processes(communicator_) == 1;
  if (!is_alone && !progress_.checkpoint) return;
  Checkpoint<dim> checkpoint{saved_field(*solution_.dof_handler, found_->displacement),
                             equilibrium_->origins(),
                             {},
                             solution_.history,
                             refinement_.state()};
  for (const ContactInterface<dim>& interface : equilibrium_->level().interfaces)
    checkpoint.active.push_back(active_places(interface));
  if (progress_.checkpoint) progress_.checkpoint(checkpoint);
  if (!is_alone) return;
  last_mesh_.keep(std::move(checkpoint));
  allocations_.forget();  // of a reserve that was too large
}

/// From the coarse mesh.
template <int dim>
void AccuracyLoop<dim>::restore(const Checkpoint<dim>& start) {
  state_ = equilibrium_->refine_as(start);
  if (!remembers(equilibrium_->level()))
    found_.emplace(state_at(equilibrium_->level(), state_.displacement));
  else if (!advance())
    throw NotConverged(solution_.stop);
  refinement_.restore(start);
  solution_.history = start.history;
  seconds_before_ = start.history.back().seconds;
  take_result();
  find_smooth_parts();
  find_strength(solution_.history.size() - 1);
  estimate();
}

/// Memory ran out: the last mesh's result is made again, on a mesh of its own.
/// @throws NotConverged if there is none
template <int dim>
void AccuracyLoop<dim>::go_back_to_last_mesh() {
  Stop why{Outcome::out_of_memory};
  if (equilibrium_) why.unknowns = equilibrium_->n_unknowns();
  const auto last = last_mesh_.take();
  state_ = {};
  found_.reset();
  solution_.contacts.clear();
  solution_.displacement.reinit(0);
  solution_.dof_handler.reset();
  solution_.element.reset();
  solution_.triangulation.reset();
  equilibrium_.reset();
  if (!last) throw NotConverged(why);
  allocations_.forget();
  start_on_coarse_mesh();
  restore(*last);
  solution_.stop = why;
}

/// The mesh may already be finer than the last one that was solved, whose displacement the guess
/// represents exactly.
template <int dim>
Solution<dim> AccuracyLoop<dim>::finish() {
  if (is_ahead_) replace(solution_.displacement, equilibrium_->ghosted(state_.displacement));
  return std::move(solution_);
}

template class AccuracyLoop<2>;
template class AccuracyLoop<3>;

}  // namespace geneva::fem
