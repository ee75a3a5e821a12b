#include "fem/contact_problem.h"

#include <deal.II/base/timer.h>
#include <deal.II/distributed/solution_transfer.h>
#include <deal.II/lac/solver_control.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <utility>

#include "base/allocation.h"
#include "base/errors.h"
#include "fem/active_set_iteration.h"
#include "fem/conditioning.h"
#include "fem/constraints.h"
#include "fem/contact/result.h"
#include "fem/distribution.h"
#include "fem/element.h"
#include "fem/hanging_vertices.h"
#include "fem/lengthwise_pressure.h"
#include "fem/numbering.h"
#include "fem/pressure_error.h"
#include "fem/problem_check.h"
#include "fem/refinement.h"
#include "fem/resource_limits.h"
#include "fem/resultants.h"
#include "fem/rigid_motion.h"
#include "fem/stopping_rule.h"
#include "fem/symmetry.h"
#include "mesh/triangulation.h"

namespace geneva::fem {

namespace {

using Vector = dealii::TrilinosWrappers::MPI::Vector;

/// Zones are made more even as long as that lowers their unevenness by this factor.
constexpr double least_gain = 0.9;
/// Cells that a refinement makes beyond the flagged ones' children, to keep the mesh graded.
constexpr double grading_overhead = 1.3;

/// Nested iteration on one problem. run() is the algorithm; the members are the current mesh and
/// its state.
template <int dim>
class NestedIteration {
 public:
  NestedIteration(const MPI_Comm communicator, const mesh::MeshData<dim>& mesh,
                  const Problem<dim>& problem, const Settings& settings,
                  const Progress<dim>& progress)
      : communicator_(communicator),
        settings_(settings),
        grading_(first_grading<dim>(settings.accuracy)),
        progress_(progress),
        limits_(communicator, settings) {
    solution_.problem = problem;
    solution_.scales = scales_of(problem, mesh);
    solution_.mesh = mesh;
    scaled_problem_ = scaled(problem, solution_.scales);
    solution_.element = linear_element<dim>(dim);
  }

  Solution<dim> run(const std::optional<Checkpoint<dim>>& start) {
    try {
      iterate(start);
    } catch (const std::bad_alloc&) {
      go_back_to_last_mesh();
    }
    return finish();
  }

 private:
  void iterate(const std::optional<Checkpoint<dim>>& start) {
    set_up_first_mesh();
    check_rigid_motions(level_, solution_.problem);
    check_approach(level_, scaled_problem_, solution_.scales, communicator_);
    if (start) {
      restore(*start);
      if (!make_next_mesh()) return;
    }
    while (solve()) {
      record();
      if (!make_next_mesh()) return;
    }
  }

  /// @return false if the refinement ends here
  bool make_next_mesh() {
    std::optional<Stop> stop = choose_refinement();
    if (!stop) stop = refine();
    if (stop) solution_.stop = *stop;
    return !stop;
  }

  void set_up_first_mesh() {
    solution_.triangulation =
        mesh::make_triangulation(communicator_, solution_.mesh, solution_.scales.length);
    solution_.dof_handler = std::make_unique<dealii::DoFHandler<dim>>(*solution_.triangulation);
    solution_.dof_handler->distribute_dofs(*solution_.element);
    number_by_neighbours(*solution_.dof_handler);
    make_level();
    guess_.reinit(level_.owned, communicator_);
  }

  void make_level() {
    unknowns_ = solution_.dof_handler->n_dofs();
    moved_vertices_ = close_gaps(*solution_.triangulation);
    level_ = fem::make_level(*solution_.dof_handler, solution_.mesh, scaled_problem_,
                             solution_.scales, origins_);
    for (std::size_t i = 0; i < solution_.contacts.size(); ++i)
      level_.interfaces[i].active = inherited_set(i);
    for (std::size_t i = 0; i < smooth_.size(); ++i) level_.interfaces[i].smooth = smooth_[i];
  }

  [[nodiscard]] std::vector<bool> inherited_set(const std::size_t i) const {
    if constexpr (dim == 2)
      return inherited(level_.interfaces[i], solution_.contacts[i].intervals,
                       solution_.scales.length);
    else
      return inherited(level_.interfaces[i], solution_.contacts[i].nodes, solution_.scales.length);
  }

  /// @return false if the active set did not settle: the last good mesh's result then stands
  bool solve() {
    while (solve_mesh()) {
      allocations_.require_none();
      if (n_active_nodes() > 0) {
        keep_result();
        return true;
      }
      refine_open_contact();
    }
    return false;
  }

  bool solve_mesh() {
    std::optional<LevelState> state;
    try {
      state = try_level();
    } catch (const dealii::SolverControl::NoConvergence& failure) {
      if (const std::string apart = open_pair(); !apart.empty())
        throw base::InputError(
            fmt::format("the load pulls contact pair {} apart, and nothing else holds the body; "
                        "check the direction of the load",
                        apart));
      return fail({Outcome::linear_solver, static_cast<double>(failure.last_step), 0.,
                   solution_.dof_handler->n_dofs(), failure.last_residual});
    }
    if (!state)
      return fail({Outcome::active_set_limit, 0.,
                   static_cast<double>(settings_.max_active_set_steps),
                   solution_.dof_handler->n_dofs()});
    state_ = std::move(*state);
    return true;
  }

  /// A node's gap is a mean over its edges: on long edges a contact may look open. The zone is
  /// refined until that gap is the one between the surfaces: three meshes with the same, since a
  /// refinement may change it little by chance.
  /// @throws base::InputError if it is open indeed
  void refine_open_contact() {
    constexpr double same = 0.01;
    constexpr unsigned int settled = 3;
    const auto [pair, gap] = nearest_pair();
    refinement_.same_open_gaps =
        std::abs(gap - refinement_.open_gap) < same * gap ? refinement_.same_open_gaps + 1 : 0;
    if (refinement_.same_open_gaps == settled || refinement_.n_refinements >= settings_.max_levels)
      throw base::InputError(fmt::format(
          "contact pair {} stays open under this load, by {:.3g} m where it is nearest: "
          "there is no contact to analyse; check the load and the distance of the "
          "bodies",
          quoted(pair), gap * solution_.scales.length));
    refinement_.open_gap = gap;
    for (ContactInterface<dim>& interface : level_.interfaces)
      interface.active = first_touch(interface);
    refined_ = Refined::zone;
    flag(state_.displacement);
    refine_flagged(state_.displacement);
    ++refinement_.n_refinements;
  }

  /// The contact pair with the least gap, and that gap.
  [[nodiscard]] std::pair<std::size_t, double> nearest_pair() const {
    std::pair<std::size_t, double> nearest{0, std::numeric_limits<double>::max()};
    for (std::size_t i = 0; i < state_.contacts.size(); ++i)
      for (const double gap : state_.contacts[i].gap)
        if (gap < nearest.second) nearest = {i, gap};
    return nearest;
  }

  [[nodiscard]] std::string quoted(const std::size_t pair) const {
    const ContactPair& names = solution_.problem.pairs[pair];
    return fmt::format("'{} -> {}'", names.source, names.target);
  }

  [[nodiscard]] unsigned int n_active_nodes() const {
    std::ptrdiff_t count = 0;
    for (const ContactInterface<dim>& interface : level_.interfaces)
      count += std::count(interface.active.begin(), interface.active.end(), true);
    return static_cast<unsigned int>(count);
  }

  /// The first contact pair without an active node; empty if there is none.
  [[nodiscard]] std::string open_pair() const {
    for (std::size_t i = 0; i < level_.interfaces.size(); ++i) {
      const auto& active = level_.interfaces[i].active;
      if (std::count(active.begin(), active.end(), true) == 0) return quoted(i);
    }
    return "";
  }

  bool fail(const Stop& why) {
    if (solution_.history.empty()) throw NotConverged(why);
    solution_.stop = why;
    return false;
  }

  std::optional<LevelState> try_level() {
    return solve_level(*solution_.dof_handler, level_, guess_, settings_,
                       [&](const unsigned int step, const unsigned int iterations) {
                         if (progress_.step)
                           progress_.step({static_cast<unsigned int>(solution_.history.size()),
                                           solution_.dof_handler->n_dofs(), step, iterations});
                       });
  }

  void find_smooth_parts() {
    if constexpr (dim == 2) {
      constexpr double share_of_accuracy = 0.1;
      smooth_.clear();
      for (std::size_t i = 0; i < level_.interfaces.size(); ++i) {
        smooth_.push_back(smooth_intervals(level_.interfaces[i], state_.contacts[i],
                                           share_of_accuracy * settings_.accuracy));
        level_.interfaces[i].smooth = smooth_.back();
      }
    }
  }

  void record() {
    find_smooth_parts();
    LevelRecord record{};
    record.cells = solution_.triangulation->n_global_active_cells();
    record.dofs = solution_.dof_handler->n_dofs();
    record.linear_iterations = state_.linear_iterations;
    for (const double peak : peaks()) record.peak_pressure = std::max(record.peak_pressure, peak);
    record_lengthwise(record);
    record.refined = refined_;
    record.halvings = last_halvings_;
    record.grading = grading_;
    record.size_measure = size_measure(*solution_.dof_handler, level_.interfaces, surface_ids(),
                                       size_decay(solution_.problem));
    record.active_nodes = n_active_nodes();
    for (const ContactInterface<dim>& interface : level_.interfaces)
      record.nodes_across += nodes_across(interface);
    record.seconds = seconds_before_ + timer_.wall_time();
    record.cycled = state_.cycled;
    record.one_solve_seconds = state_.assemble_and_solve_seconds;
    solution_.history.push_back(record);
    estimate();
    if (progress_.level) progress_.level(solution_.history.back());
    if (progress_.solution) progress_.solution(solution_);
    save();
  }

  /// Of one rank's memory the last mesh's state is kept, too, for when it runs out.
  void save() {
    const bool is_alone = dealii::Utilities::MPI::n_mpi_processes(communicator_) == 1;
    if (!is_alone && !progress_.checkpoint) return;
    Checkpoint<dim> checkpoint{saved_field(*solution_.dof_handler, state_.displacement),
                               *origins_,
                               {},
                               solution_.history,
                               refinement_};
    for (const ContactInterface<dim>& interface : level_.interfaces)
      checkpoint.active.push_back(active_places(interface));
    if (progress_.checkpoint) progress_.checkpoint(checkpoint);
    if (!is_alone) return;
    last_good_ = std::move(checkpoint);
    keep_reserve(solution_.history.back().dofs);
  }

  /// What the results of a mesh take to be written: resident memory grows by 480 bytes per unknown
  /// then (measured in 3-D, with 57 000), and the mesh has to be made again before. The reserve
  /// is never touched: it takes addresses only, which are what runs out when an allocation fails.
  void keep_reserve(const std::size_t unknowns) {
    constexpr std::size_t least = 16U << 20U;
    reserve_.reset();
    for (std::size_t size = least + 1000 * unknowns; !reserve_ && size >= least; size /= 2)
      reserve_.reset(new (std::nothrow) char[size]);
    allocations_.forget();
  }

  /// From the coarse mesh.
  void restore(const Checkpoint<dim>& start) {
    if (start.active.size() != solution_.problem.pairs.size())
      throw base::InputError("the checkpoint does not fit this case: it has other contact pairs");
    put_back(*solution_.triangulation, moved_vertices_);
    refine_as(*solution_.triangulation, start.field);
    solution_.dof_handler->distribute_dofs(*solution_.element);
    number_by_neighbours(*solution_.dof_handler);
    origins_ = start.origins;
    solution_.contacts.clear();
    smooth_.clear();
    make_level();
    for (std::size_t i = 0; i < start.active.size(); ++i)
      level_.interfaces[i].active = active_at(level_.interfaces[i], start.active[i]);
    guess_ = field_on(*solution_.dof_handler, start.field);
    state_ = state_at(level_, guess_);
    refinement_ = start.refinement;
    solution_.history = start.history;
    grading_ = start.history.back().grading;
    refined_ = start.history.back().refined;
    seconds_before_ = start.history.back().seconds;
    keep_result();
    find_smooth_parts();
    estimate();
  }

  /// Memory ran out: the last mesh's result is made again, on a mesh of its own.
  /// @throws NotConverged if there is none
  void go_back_to_last_mesh() {
    const Stop why{Outcome::out_of_memory, 0., 0., unknowns_};
    reserve_.reset();
    level_ = Level<dim>();
    state_ = LevelState();
    smooth_.clear();
    guess_.clear();
    solution_.contacts.clear();
    solution_.displacement.clear();
    solution_.dof_handler.reset();
    solution_.triangulation.reset();
    if (!last_good_) throw NotConverged(why);
    allocations_.forget();
    set_up_first_mesh();
    restore(*last_good_);
    solution_.stop = why;
  }

  /// Greatest pressures of the pairs [Pa], as the mesh gives them.
  [[nodiscard]] std::vector<double> peaks() const {
    std::vector<double> result;
    for (const ContactResult<dim>& contact : solution_.contacts)
      result.push_back(contact.peak_pressure);
    return result;
  }

  void estimate() {
    solution_.has_free_ends = has_free_ends(level_.interfaces);
    const bool forces_are_given = dim == 2 && !has_prescribed_displacement(solution_.problem);
    error_ = pressure_error<dim>(
        solution_.history,
        {{forces_are_given, reaches_axis(), peaks_beside_end(level_.interfaces, state_.contacts)},
         grading_,
         end_error(level_.interfaces, state_.contacts, reaches_axis()),
         solution_.has_free_ends,
         has_spread(),
         refinement_.surroundings_are_fine});
    solution_.edge = error_.edge;
    solution_.correction = error_.correction;
    solution_.error_estimate = error_.total();
    solution_.history.back().error_estimate =
        error_.is_of_peak() ? error_.total() : std::min(1., 2. * error_.total());
    for (ContactResult<dim>& contact : solution_.contacts)
      contact.peak_pressure *= 1. + solution_.correction;
  }

  void record_lengthwise([[maybe_unused]] LevelRecord& record) const {
    if constexpr (dim == 3)
      for (const ContactResult<3>& contact : solution_.contacts) {
        const LengthwisePressure greatest = lengthwise_pressure(
            contact, symmetry_plane(solution_.mesh, solution_.problem, contact, 2));
        record.mid_length_pressure = std::max(record.mid_length_pressure, greatest.middle);
        record.end_pressure = std::max(record.end_pressure, greatest.end);
      }
  }

  /// Whether the greatest pressure stands at an end or a corner of its surfaces; elsewhere it has a
  /// bound, however steeply it rises. In 3-D the surfaces always have edges.
  [[nodiscard]] bool peaks_at_corner() const {
    if constexpr (dim == 2) {
      const std::vector<double> greatest = peaks();
      const auto pair = static_cast<std::size_t>(
          std::max_element(greatest.begin(), greatest.end()) - greatest.begin());
      return fem::peaks_at_corner(level_.interfaces[pair], state_.contacts[pair]);
    }
    return true;
  }

  [[nodiscard]] Standing standing() const {
    return {solution_.error_estimate, solution_.edge, peaks_at_corner(), refinement_.n_refinements};
  }

  /// Flags what is worth more: the contact zone until its part of the error is small, then the
  /// cells around it. In 3-D, where the zone takes most of the cells, the latter once before.
  /// @return why there is no next mesh, if there is none
  std::optional<Stop> choose_refinement() {
    constexpr double share_of_zone = 0.6;
    if (const auto stop = why_to_stop(solution_.history, standing(), settings_)) return stop;
    if (has_spread()) return level_off();
    const bool zone_is_fine = error_.zone <= share_of_zone * settings_.accuracy;
    double flagged = 0.;
    if (error_.surroundings > 0. && (zone_is_fine || surroundings_come_first())) {
      refined_ = Refined::surroundings;
      grading_ *= grading_step<dim>;
      flagged = flag(state_.displacement);
      if (flagged == 0. && zone_is_fine) return surroundings_are_fine();
    }
    if (flagged == 0.) {
      refined_ = Refined::zone;
      flagged = flag(state_.displacement);
    }
    return limits_.exceeded_by_next(growth_by(flagged), solution_.history, seconds_before_);
  }

  /// Whether the contact has become wider than the zone that was refined: edges of very different
  /// lengths, whose pressure is of no use, and that can be made more equal.
  [[nodiscard]] bool has_spread() const {
    constexpr double greatest_ratio = 4.;
    return unevenness_now() > greatest_ratio &&
           unevenness_now() < least_gain * refinement_.unevenness_levelled;
  }

  /// Flags the longest edges of the zones only; how wide they must be is known after the next
  /// solve.
  std::optional<Stop> level_off() {
    refined_ = Refined::nothing;
    refinement_.unevenness_levelled = unevenness_now();
    const double growth = growth_by(flag_zone_part(*solution_.dof_handler, level_.interfaces,
                                                   surface_ids(), ZonePart::longest));
    return limits_.exceeded_by_next(growth, solution_.history, seconds_before_);
  }

  /// Whether the part of the surroundings is still to be measured, on a mesh where the pressure is
  /// of use or because a finer zone is dear.
  bool surroundings_come_first() {
    constexpr double dear = 4.;
    const bool is_measured = std::any_of(
        solution_.history.begin(), solution_.history.end(),
        [](const LevelRecord& level) { return level.refined == Refined::surroundings; });
    if (dim == 2 || is_measured || !is_resolved()) return false;
    if (error_.zone < 1.) return true;
    refined_ = Refined::zone;
    const bool result = growth_by(flag(state_.displacement)) > dear;
    for (const auto& cell : solution_.triangulation->active_cell_iterators())
      cell->clear_refine_flag();
    return result;
  }

  /// No cell around the contact is larger than asked for: only the zone's part of the error is
  /// left.
  std::optional<Stop> surroundings_are_fine() {
    refinement_.surroundings_are_fine = true;
    error_.surroundings = 0.;
    solution_.error_estimate = error_.zone;
    solution_.history.back().error_estimate = error_.zone;
    return choose_refinement();
  }

  /// How many times as many cells the next mesh will have.
  [[nodiscard]] double growth_by(const double flagged) const {
    return 1. + grading_overhead * ((1 << dim) - 1) * flagged / solution_.history.back().cells;
  }

  [[nodiscard]] bool is_resolved() const {
    return !solution_.history.empty() && solution_.history.back().nodes_across >= nodes_for_grading;
  }

  double flag(const Vector& displacement) {
    return flag_cells(
        *solution_.dof_handler, displacement, level_.interfaces, surface_ids(),
        {refined_ == Refined::zone, is_resolved() ? std::optional(grading_) : std::nullopt,
         size_growth(solution_.problem)});
  }

  /// Refines the flagged cells; while the load still acts on single nodes, whose pressure is of no
  /// use, the zone around them is refined once more before the next solve.
  /// @return why the mesh is not to be solved, if it is not: the last one's result then stands
  std::optional<Stop> refine() {
    last_halvings_ = refined_ == Refined::zone ? 1 : 0;
    ++refinement_.n_refinements;
    refine_flagged(state_.displacement);
    is_ahead_ = true;
    if (refined_ == Refined::nothing) return std::nullopt;
    if (next_pressure_is_of_no_use() && refinement_.n_refinements < settings_.max_levels) {
      const Vector guess = ghosted_guess();
      flag(guess);
      ++refinement_.n_refinements;
      refine_flagged(guess);
      last_halvings_ = 2;
    }
    make_zones_even();
    return limits_.exceeded_by(solution_.dof_handler->n_dofs());
  }

  /// Whether the next mesh, too, would have too few nodes in contact; in the plane, where meshes
  /// are cheap, whether this one has.
  [[nodiscard]] bool next_pressure_is_of_no_use() const {
    const unsigned int across = solution_.history.back().nodes_across;
    const unsigned int expected = dim == 2 || across == 0 ? across : 2 * across - 1;
    return expected < fewest_active_nodes;
  }

  /// Ends where it helps little: cells that share a vertex differ by one level at most, so that
  /// neighbours whose sizes differ by more cannot be made equal.
  void make_zones_even() {
    double before = std::numeric_limits<double>::max();
    for (double now = unevenness_now(); now < least_gain * before; now = unevenness_now()) {
      if (flag_zone_part(*solution_.dof_handler, level_.interfaces, surface_ids(),
                         ZonePart::uneven) == 0)
        return;
      refine_flagged(ghosted_guess());
      if (dim == 2) before = now;  // in 3-D the levels of a zone can always be made equal
    }
  }

  [[nodiscard]] double unevenness_now() const {
    if constexpr (dim == 2) return unevenness(level_.interfaces);
    return 1.;
  }

  [[nodiscard]] Vector ghosted_guess() const {
    Vector guess(level_.owned, level_.ghosts, communicator_);
    guess = guess_;
    return guess;
  }

  [[nodiscard]] std::vector<std::pair<unsigned int, unsigned int>> surface_ids() const {
    std::vector<std::pair<unsigned int, unsigned int>> ids;
    for (const ContactPair& pair : solution_.problem.pairs)
      ids.emplace_back(index_of(solution_.mesh.surfaces, pair.source),
                       index_of(solution_.mesh.surfaces, pair.target));
    return ids;
  }

  void refine_flagged(Vector displacement) {
    auto& triangulation = *solution_.triangulation;
    auto& dof_handler = *solution_.dof_handler;
    put_back(triangulation, moved_vertices_);
    triangulation.prepare_coarsening_and_refinement();
    distribute_for_refinement(triangulation, dof_handler, displacement);
    dealii::parallel::distributed::SolutionTransfer<dim, Vector> transfer(dof_handler);
    transfer.prepare_for_coarsening_and_refinement(displacement);
    triangulation.execute_coarsening_and_refinement();
    dof_handler.distribute_dofs(*solution_.element);
    number_by_neighbours(dof_handler);
    guess_.reinit(dof_handler.locally_owned_dofs(), communicator_);
    transfer.interpolate(guess_);
    make_level();
  }

  /// Whether a contact begins on the axis of revolution.
  [[nodiscard]] bool reaches_axis() const {
    return solution_.problem.plane == PlaneKind::axisymmetric &&
           std::any_of(level_.interfaces.begin(), level_.interfaces.end(),
                       [](const auto& interface) {
                         const auto& active = interface.active;
                         return !active.empty() && active.front() != active.back();
                       });
  }

  void keep_result() {
    solution_.contacts.clear();
    for (std::size_t i = 0; i < level_.interfaces.size(); ++i)
      solution_.contacts.push_back(contact_result(solution_.problem.pairs[i], level_.interfaces[i],
                                                  state_.contacts[i], solution_.scales));
    for (ContactResult<dim>& contact : solution_.contacts) {
      const auto places = mirrors(solution_.mesh, solution_.problem, contact);
      for (unsigned int i = 0; i < dim; ++i)
        if (places[i]) std::swap(contact.force[i], contact.lateral_force[i]);
      if constexpr (dim == 2) count_from_mirrors(contact, places, solution_.scales.length);
    }
    solution_.reactions = reactions(solution_, level_, state_);
    const AppliedLoad<dim> load = applied_load(solution_, level_);
    solution_.applied_force = load.force;
    solution_.applied_moment = load.moment;
    solution_.displacement = state_.displacement;
    is_ahead_ = false;
  }

  /// The mesh may already be finer than the last good state, which the guess represents exactly.
  Solution<dim> finish() {
    if (is_ahead_) {
      solution_.displacement.reinit(level_.owned, level_.ghosts, communicator_);
      solution_.displacement = guess_;
    }
    return std::move(solution_);
  }

  MPI_Comm communicator_;
  Settings settings_;
  double grading_;
  Progress<dim> progress_;
  Problem<dim> scaled_problem_;
  dealii::Timer timer_;
  ResourceLimits limits_;
  Solution<dim> solution_;
  std::optional<SurfaceOrigins<dim>> origins_;
  RefinementState refinement_;
  Refined refined_ = Refined::nothing;  ///< by the last refinement
  unsigned int last_halvings_ = 0;      ///< of the contact's cells between the last two meshes
  std::vector<ArcIntervals> smooth_;    ///< by pair, see ContactInterface
  VertexPlaces<dim> moved_vertices_;
  Level<dim> level_;
  LevelState state_;
  Vector guess_;
  PressureError error_;
  base::AllocationWatch allocations_;
  std::size_t unknowns_ = 0;                  ///< of the mesh being solved or refined
  std::optional<Checkpoint<dim>> last_good_;  ///< on one rank
  std::unique_ptr<char[]> reserve_;           ///< for that
  double seconds_before_ = 0.;                ///< of the runs that this one continues
  bool is_ahead_ = false;  ///< whether the mesh is finer than that of solution_.displacement
};

/// A coarse mesh is solved whatever the limit of unknowns says, unless that takes more than
/// seconds.
template <int dim>
void check_size(const mesh::MeshData<dim>& mesh, const Settings& settings) {
  constexpr std::size_t small = 100'000;
  const std::size_t unknowns = dim * mesh.vertices.size();
  if (unknowns > std::max<std::size_t>(small, settings.max_dofs))
    throw NotConverged({Outcome::coarse_dof_limit, static_cast<double>(unknowns),
                        static_cast<double>(settings.max_dofs), unknowns});
}

}  // namespace

template <int dim>
Solution<dim> solve_contact(const MPI_Comm communicator, const mesh::MeshData<dim>& mesh,
                            const Problem<dim>& problem, const Settings& settings,
                            const Progress<dim>& progress,
                            const std::optional<Checkpoint<dim>>& start) {
  check_size(mesh, settings);
  check(problem, mesh);
  check_stiffness_ratio(problem, mesh);
  return NestedIteration<dim>(communicator, mesh, problem, settings, progress).run(start);
}

template Solution<2> solve_contact(MPI_Comm, const mesh::MeshData<2>&, const Problem<2>&,
                                   const Settings&, const Progress<2>&,
                                   const std::optional<Checkpoint<2>>&);
template Solution<3> solve_contact(MPI_Comm, const mesh::MeshData<3>&, const Problem<3>&,
                                   const Settings&, const Progress<3>&,
                                   const std::optional<Checkpoint<3>>&);

}  // namespace geneva::fem
