#include "fem/contact_problem.h"

#include <deal.II/base/timer.h>
#include <deal.II/base/utilities.h>
#include <deal.II/distributed/solution_transfer.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/lac/solver_control.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "fem/constraints.h"
#include "fem/contact/result.h"
#include "fem/level.h"
#include "fem/refinement.h"
#include "mesh/triangulation.h"

namespace geneva::fem {

namespace {

using Vector = dealii::TrilinosWrappers::MPI::Vector;

/// Contact zones with fewer active nodes say nothing about the pressure yet.
constexpr unsigned int resolved_nodes = 6;
/// Cells that a refinement makes beyond the flagged ones' children, to keep the mesh graded.
constexpr double grading_overhead = 1.3;

/// Forces that supports and ties exert, from the residual at their nodes.
std::vector<Reaction> reactions(const Solution& solution, const Level& level,
                                const Vector& residual) {
  std::vector<std::string> surfaces;
  for (const Support& support : solution.problem.supports) surfaces.push_back(support.surface);
  for (const RigidTie& tie : solution.problem.ties) surfaces.push_back(tie.surface);
  std::vector<Reaction> result;
  std::set<unsigned int> counted;
  for (const std::string& name : surfaces) {
    Reaction reaction{name, {}, 0.};
    const unsigned int surface = index_of(solution.mesh.surfaces, name);
    for (const BoundaryFace& face : level.boundary.faces) {
      if (face.surface != surface) continue;
      for (const unsigned int index : face.nodes) {
        if (!counted.insert(index).second) continue;
        const BoundaryNode& node = level.boundary.nodes[index];
        const std::array<double, 2> force{
            level.held.count(node.dofs[0]) > 0 ? residual(node.dofs[0]) * solution.scales.force()
                                               : 0.,
            level.held.count(node.dofs[1]) > 0 ? residual(node.dofs[1]) * solution.scales.force()
                                               : 0.};
        reaction.force[0] += force[0];
        reaction.force[1] += force[1];
        reaction.moment +=
            (node.position[0] * force[1] - node.position[1] * force[0]) * solution.scales.length;
      }
    }
    result.push_back(reaction);
  }
  return result;
}

/// Resultant of body forces and surface loads, and its moment about the origin.
std::pair<std::array<double, 2>, double> applied_load(const Solution& solution,
                                                      const Level& level) {
  std::array<double, 3> sums{0., 0., 0.};
  auto cell_system = level.cells.begin();
  for (const auto& cell : solution.dof_handler->active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    for (unsigned int i = 0; i < cell_system->load.size(); ++i) {
      const auto [component, vertex] = solution.element->system_to_component_index(i);
      const double force = cell_system->load[i] * solution.scales.force();
      sums[component] += force;
      const double arm = component == 0 ? -cell->vertex(vertex)[1] : cell->vertex(vertex)[0];
      sums[2] += force * arm * solution.scales.length;
    }
    ++cell_system;
  }
  const MPI_Comm communicator = solution.dof_handler->get_communicator();
  for (double& sum : sums) sum = dealii::Utilities::MPI::sum(sum, communicator);
  return {{sums[0], sums[1]}, sums[2]};
}

/// Share of the peak pressure that is open because a free end of the contact lies somewhere on an
/// edge: a coefficient over the square of the number of active nodes. Measured on unsymmetric
/// meshes with 7 to 35 nodes: 0.9 to 1.2.
double end_uncertainty(const ContactInterface& interface) {
  constexpr double coefficient = 1.2;
  double uncertainty = 0.;
  const auto& active = interface.active;
  for (std::size_t begin = 0; begin < active.size(); ++begin) {
    if (!active[begin] || (begin > 0 && active[begin - 1])) continue;
    std::size_t end = begin;
    while (end < active.size() && active[end]) ++end;
    const bool starts_free = begin > 0;
    const bool ends_free = end < active.size();
    if (!starts_free && !ends_free) continue;
    // A contact with one free end is half of one: the other end is a plane or axis of symmetry.
    const double nodes = static_cast<double>(end - begin) * (starts_free && ends_free ? 1. : 2.);
    uncertainty = std::max(uncertainty, coefficient / (nodes * nodes));
  }
  return uncertainty;
}

/// Nested iteration on one problem. run() is the algorithm; the members are the current mesh and
/// its state.
class NestedIteration {
 public:
  NestedIteration(const MPI_Comm communicator, const mesh::MeshData& mesh, const Problem& problem,
                  const Settings& settings, const Progress& progress)
      : communicator_(communicator), settings_(settings), progress_(progress) {
    solution_.problem = problem;
    solution_.scales = scales_of(problem, mesh);
    solution_.mesh = mesh;
    scaled_problem_ = scaled(problem, solution_.scales);
    solution_.triangulation = mesh::make_triangulation(communicator, mesh, solution_.scales.length);
    solution_.element = std::make_unique<dealii::FESystem<2>>(dealii::FE_Q<2>(1), 2);
    solution_.dof_handler = std::make_unique<dealii::DoFHandler<2>>(*solution_.triangulation);
  }

  Solution run() {
    set_up_first_mesh();
    while (solve()) {
      record();
      if (finished()) break;
      refine();
    }
    return finish();
  }

 private:
  void set_up_first_mesh() {
    solution_.dof_handler->distribute_dofs(*solution_.element);
    make_level();
    guess_.reinit(level_.owned, communicator_);
  }

  void make_level() {
    level_ = fem::make_level(*solution_.dof_handler, solution_.mesh, scaled_problem_,
                             solution_.scales, origins_);
    for (std::size_t i = 0; i < intervals_.size(); ++i)
      level_.interfaces[i].active = inherited(level_.interfaces[i], intervals_[i]);
  }

  /// @return false if the active set did not settle: the last good mesh's result then stands
  bool solve() {
    std::optional<LevelState> state;
    try {
      state = try_level();
    } catch (const dealii::SolverControl::NoConvergence& failure) {
      return fail(fmt::format(
          "the linear solver did not converge on a mesh of {} unknowns (residual {:.2e} after {} "
          "iterations); check that supports and contact pairs hold every body",
          solution_.dof_handler->n_dofs(), failure.last_residual, failure.last_step));
    }
    if (!state)
      return fail(fmt::format(
          "the active set did not settle within {} steps on a mesh of {} unknowns; raise 'Maximum "
          "active-set steps', or check that supports and contact pairs hold every body",
          settings_.max_active_set_steps, solution_.dof_handler->n_dofs()));
    state_ = std::move(*state);
    return true;
  }

  bool fail(const std::string& message) {
    end(Outcome::active_set_limit, message);
    if (solution_.history.empty()) throw NotConverged(message);
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

  void record() {
    LevelRecord record{};
    record.cells = solution_.triangulation->n_global_active_cells();
    record.dofs = solution_.dof_handler->n_dofs();
    record.linear_iterations = state_.linear_iterations;
    for (const ContactState& contact : state_.contacts)
      for (const double pressure : contact.pressure)
        record.peak_pressure = std::max(record.peak_pressure, pressure * solution_.scales.stress);
    for (const ContactInterface& interface : level_.interfaces)
      record.active_nodes += static_cast<unsigned int>(
          std::count(interface.active.begin(), interface.active.end(), true));
    record.change = change(record);
    record.error_estimate = estimate(record);
    record.seconds = timer_.wall_time();
    record.one_solve_seconds = level_.cell_seconds + state_.assemble_and_solve_seconds;
    solution_.history.push_back(record);
    solution_.error_estimate = record.error_estimate;
    if (progress_.level) progress_.level(record);
  }

  [[nodiscard]] double change(const LevelRecord& now) const {
    if (solution_.history.empty() || now.peak_pressure <= 0.) return 1.;
    return std::min(1., std::abs(now.peak_pressure / solution_.history.back().peak_pressure - 1.));
  }

  /// Relative error of the peak pressure: the greatest of
  /// - its change from the mesh before, which bounds the remaining error since halving the edges
  /// halves it at least;
  /// - a quarter of the change before that, lest two meshes agree by chance;
  /// - what the contact's ends are worth that lie somewhere between two nodes (see
  /// end_uncertainty).
  [[nodiscard]] double estimate(const LevelRecord& now) const {
    if (now.active_nodes < resolved_nodes || solution_.history.empty()) return 1.;
    double ends = 0.;
    for (const ContactInterface& interface : level_.interfaces)
      ends = std::max(ends, end_uncertainty(interface));
    return std::min(1., std::max({now.change, solution_.history.back().change / 4., ends}));
  }

  bool finished() {
    if (solution_.error_estimate <= settings_.accuracy) {
      end(Outcome::converged, "");
      return true;
    }
    if (solution_.history.size() > settings_.max_levels)
      return end(Outcome::level_limit,
                 fmt::format("the limit of {} refinement levels was reached; raise 'Maximum "
                             "refinement levels'",
                             settings_.max_levels));
    dealii::Utilities::System::MemoryStats memory{};
    dealii::Utilities::System::get_memory_stats(memory);
    const double peak_memory =
        dealii::Utilities::MPI::sum(1024. * static_cast<double>(memory.VmHWM), communicator_);
    if (peak_memory > settings_.max_memory)
      return end(Outcome::memory_limit,
                 fmt::format("the memory limit of {:.0f} MB was reached ({:.0f} MB are in use); "
                             "raise 'Maximum memory'",
                             settings_.max_memory / 1e6, peak_memory / 1e6));
    intervals_.clear();
    for (const ContactInterface& interface : level_.interfaces)
      intervals_.push_back(active_intervals(interface));
    const double flagged = flag();
    const double next_dofs =
        (1. + grading_overhead * 3. * flagged / solution_.history.back().cells) *
        solution_.history.back().dofs;
    if (next_dofs > settings_.max_dofs)
      return end(Outcome::dof_limit, fmt::format("the next mesh would have about {:.0f} unknowns, "
                                                 "the limit is {}; raise 'Maximum unknowns'",
                                                 next_dofs, settings_.max_dofs));
    return false;
  }

  bool end(const Outcome outcome, const std::string& message) {
    solution_.outcome = outcome;
    solution_.message = message;
    return true;
  }

  double flag() {
    std::vector<std::pair<unsigned int, unsigned int>> ids;
    for (const ContactPair& pair : solution_.problem.pairs)
      ids.emplace_back(index_of(solution_.mesh.surfaces, pair.source),
                       index_of(solution_.mesh.surfaces, pair.target));
    return flag_cells(*solution_.dof_handler, state_.displacement, level_.interfaces, ids,
                      solution_.history.back().active_nodes >= resolved_nodes / 2);
  }

  void refine() {
    keep_result();
    auto& triangulation = *solution_.triangulation;
    auto& dof_handler = *solution_.dof_handler;
    dealii::parallel::distributed::SolutionTransfer<2, Vector> transfer(dof_handler);
    triangulation.prepare_coarsening_and_refinement();
    const Vector before = state_.displacement;
    transfer.prepare_for_coarsening_and_refinement(before);
    triangulation.execute_coarsening_and_refinement();
    dof_handler.distribute_dofs(*solution_.element);
    guess_.reinit(dof_handler.locally_owned_dofs(), communicator_);
    transfer.interpolate(guess_);
    make_level();
  }

  void keep_result() {
    solution_.contacts.clear();
    for (std::size_t i = 0; i < level_.interfaces.size(); ++i)
      solution_.contacts.push_back(contact_result(solution_.problem.pairs[i], level_.interfaces[i],
                                                  state_.contacts[i], solution_.scales));
    solution_.reactions = reactions(solution_, level_, state_.residual);
    std::tie(solution_.applied_force, solution_.applied_moment) = applied_load(solution_, level_);
    solution_.displacement = state_.displacement;
  }

  /// After a failure the mesh is already finer than the last good state, which the guess represents
  /// exactly.
  Solution finish() {
    if (solution_.outcome == Outcome::active_set_limit) {
      solution_.displacement.reinit(level_.owned, level_.ghosts, communicator_);
      solution_.displacement = guess_;
    } else {
      keep_result();
    }
    return std::move(solution_);
  }

  MPI_Comm communicator_;
  Settings settings_;
  Progress progress_;
  Problem scaled_problem_;
  dealii::Timer timer_;
  Solution solution_;
  std::optional<SurfaceOrigins> origins_;
  std::vector<std::vector<std::pair<double, double>>> intervals_;
  Level level_;
  LevelState state_;
  Vector guess_;
};

void require_name(const std::vector<std::string>& names, const std::string& name,
                  const std::string& what) {
  if (!name.empty() && std::find(names.begin(), names.end(), name) != names.end()) return;
  std::string known;
  for (const std::string& candidate : names)
    if (!candidate.empty()) known += (known.empty() ? "'" : ", '") + candidate + "'";
  throw std::invalid_argument(
      fmt::format("{} '{}' is not in the mesh; the mesh has {}", what, name, known));
}

void check_names(const Problem& problem, const mesh::MeshData& mesh) {
  for (const Body& body : problem.bodies) require_name(mesh.bodies, body.name, "body");
  for (const Support& support : problem.supports)
    require_name(mesh.surfaces, support.surface, "support surface");
  for (const SurfaceLoad& load : problem.loads)
    require_name(mesh.surfaces, load.surface, "loaded surface");
  for (const RigidTie& tie : problem.ties)
    require_name(mesh.surfaces, tie.surface, "rigid surface");
  for (const ContactPair& pair : problem.pairs) {
    require_name(mesh.surfaces, pair.source, "contact surface");
    require_name(mesh.surfaces, pair.target, "contact surface");
  }
}

/// @return the one body that a contact surface belongs to
unsigned int contact_body(const mesh::MeshData& mesh, const std::string& surface) {
  const auto bodies = mesh::bodies_of(mesh, index_of(mesh.surfaces, surface));
  if (bodies.empty())
    throw std::invalid_argument(
        fmt::format("contact surface '{}' is empty: it has no edges", surface));
  if (bodies.size() > 1)
    throw std::invalid_argument(
        fmt::format("contact surface '{}' belongs to {} bodies; give each body its own surface",
                    surface, bodies.size()));
  return *bodies.begin();
}

void check_pairs(const Problem& problem, const mesh::MeshData& mesh) {
  if (problem.pairs.empty()) throw std::invalid_argument("the problem has no contact pair");
  std::set<std::string> sources;
  for (const ContactPair& pair : problem.pairs) {
    if (pair.source == pair.target)
      throw std::invalid_argument(
          fmt::format("contact surface '{}' cannot touch itself", pair.source));
    if (contact_body(mesh, pair.source) == contact_body(mesh, pair.target))
      throw std::invalid_argument(fmt::format(
          "contact surfaces '{}' and '{}' belong to the same body", pair.source, pair.target));
    if (!sources.insert(pair.source).second)
      throw std::invalid_argument(fmt::format(
          "surface '{}' is the source of two contact pairs; make it the target of one of them",
          pair.source));
  }
  for (const ContactPair& pair : problem.pairs)
    if (sources.count(pair.target) > 0)
      throw std::invalid_argument(fmt::format(
          "contact surfaces overlap: '{}' is the source of one pair and the target of another",
          pair.target));
}

/// A body that nothing holds and nothing touches can float away.
void check_held(const Problem& problem, const mesh::MeshData& mesh) {
  std::set<unsigned int> held;
  const auto add = [&](const std::string& surface) {
    const auto bodies = mesh::bodies_of(mesh, index_of(mesh.surfaces, surface));
    held.insert(bodies.begin(), bodies.end());
  };
  for (const Support& support : problem.supports) add(support.surface);
  for (const RigidTie& tie : problem.ties) add(tie.surface);
  for (const ContactPair& pair : problem.pairs) {
    add(pair.source);
    add(pair.target);
  }
  for (unsigned int body = 0; body < mesh.bodies.size(); ++body)
    if (held.count(body) == 0)
      throw std::invalid_argument(
          fmt::format("body '{}' has neither a support nor a contact surface: nothing holds it",
                      mesh.bodies[body]));
}

}  // namespace

void order_bodies(Problem& problem, const mesh::MeshData& mesh) {
  for (const Body& body : problem.bodies) require_name(mesh.bodies, body.name, "body");
  std::vector<Body> ordered;
  for (const std::string& name : mesh.bodies) {
    const auto body = std::find_if(problem.bodies.begin(), problem.bodies.end(),
                                   [&](const Body& candidate) { return candidate.name == name; });
    if (body == problem.bodies.end())
      throw std::invalid_argument(
          fmt::format("body '{}' of the mesh has no material; name it in 'Bodies'", name));
    ordered.push_back(*body);
  }
  problem.bodies = ordered;
}

void check(const Problem& problem, const mesh::MeshData& mesh) {
  check_names(problem, mesh);
  check_pairs(problem, mesh);
  check_held(problem, mesh);
}

Solution solve_contact(const MPI_Comm communicator, const mesh::MeshData& mesh,
                       const Problem& problem, const Settings& settings, const Progress& progress) {
  check(problem, mesh);
  return NestedIteration(communicator, mesh, problem, settings, progress).run();
}

}  // namespace geneva::fem
