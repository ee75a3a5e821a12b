#pragma once

#include <functional>
#include <optional>
#include <variant>
#include <vector>

#include "fem/active_set_iteration.h"
#include "fem/checkpoint.h"
#include "fem/discretisation/refined_mesh.h"
#include "fem/discretisation/vector.h"
#include "fem/instant.h"
#include "fem/level.h"
#include "fem/problem/load.h"
#include "fem/problem/stop.h"

namespace geneva::fem {

/// Where the search for an equilibrium starts: a displacement of the mesh as it is, and what is
/// known of the contacts by place, whatever the mesh.
template <int dim>
struct State {
  Vector displacement;  ///< without ghosts
  PointValues history;  ///< what materials remember of the instants before, see remembered()
  std::vector<ContactResult<dim>> contacts;  ///< of the last mesh that was solved; empty before
  std::vector<ArcIntervals> smooth;          ///< by pair, see ContactInterface
};

/// A state in equilibrium, or why none was found.
using Solved = std::variant<LevelState, Stop>;

/// Where the solver is chosen automatically and ours does not converge, the library's takes over.
/// @param solve with the linear solver of its settings
Solved with_fallback(const Settings& settings, const std::function<Solved(const Settings&)>& solve);

/// The bodies at one instant on a mesh: finds the state in which they are in equilibrium with their
/// loads and each other, and takes states over to finer meshes.
template <int dim>
class Equilibrium {
 public:
  /// On the coarse mesh.
  /// @param mesh SI units, the same on all ranks
  /// @throws base::InputError where check_rigid_motions() and check_approach() do, and if loads
  /// pull a body away that only a contact could hold
  Equilibrium(MPI_Comm communicator, const mesh::MeshData<dim>& mesh, const Problem<dim>& problem,
              const Scales& scales);

  /// Without a displacement, in contact where the bodies are nearest.
  [[nodiscard]] State<dim> at_rest() const;

  /// One solve, from a state on.
  /// @param load what acts at the instant
  /// @throws base::InputError if the load pulls a body away that only an open contact could hold
  Solved advance(const State<dim>& from, const Load& load, const Settings& settings,
                 const StepObserver& observer);

  /// Refines the flagged cells.
  /// @param displacement with ghosts; what else is known of the contacts is `now`'s
  State<dim> refine(const Vector& displacement, State<dim> now);

  /// Goes over from the coarse mesh to that of a checkpoint.
  /// @return the checkpoint's displacement
  /// @throws base::InputError if it does not fit
  State<dim> refine_as(const Checkpoint<dim>& checkpoint);

  /// In contact where the bodies are nearest, whatever has been found.
  void touch_first();

  /// Where the pressure is smooth, so that the zones there need no finer edges.
  void set_smooth(const std::vector<ArcIntervals>& smooth);

  /// Where the next instant starts from.
  /// @param before where this one started from, on this mesh
  /// @param found its equilibrium
  [[nodiscard]] State<dim> end_of_instant(State<dim> before, const LevelState& found) const;

  /// Slip counts from this state on.
  void remember_slip(const LevelState& found);
  /// Slip counts from the undisplaced bodies on.
  void forget_slip();

  /// Lets nodes stick and slide as they did at an instant on another mesh.
  void recall(const Instant<dim>& instant);

  /// A vector with ghosts.
  [[nodiscard]] Vector ghosted(const Vector& displacement) const;

  /// Of the mesh being solved or refined, also where memory ran out half-way.
  [[nodiscard]] std::size_t n_unknowns() const { return n_unknowns_; }

  [[nodiscard]] const Level<dim>& level() const { return level_; }
  [[nodiscard]] const RefinedMesh<dim>& mesh() const { return mesh_; }
  [[nodiscard]] const Scales& scales() const { return scales_; }
  /// Where contact surfaces that are closed are cut open.
  [[nodiscard]] const SurfaceOrigins<dim>& origins() const { return *origins_; }

 private:
  void make_level(const State<dim>& state);
  void tell_what_holds();
  void set_load(const Load& load);
  Solved solve(const State<dim>& from, const Settings& settings, const StepObserver& observer);
  void check_that_loads_close();
  void check_that_contact_holds() const;
  void open_what_pulls(const std::vector<ContactState>& contacts);

  MPI_Comm communicator_;
  mesh::MeshData<dim> coarse_;
  Problem<dim> problem_;
  Problem<dim> scaled_problem_;
  Scales scales_;
  RefinedMesh<dim> mesh_;
  std::optional<SurfaceOrigins<dim>> origins_;
  std::size_t n_unknowns_ = 0;
  bool is_held_by_friction_ = false;     ///< see Level
  std::vector<bool> holds_by_friction_;  ///< see Level
  std::vector<bool> holds_by_contact_;   ///< see Level
  Load load_;                            ///< of the level
  Level<dim> level_;
};

}  // namespace geneva::fem
