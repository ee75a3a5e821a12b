#pragma once

#include <deal.II/base/timer.h>

#include <optional>
#include <vector>

#include "base/allocation.h"
#include "fem/adaptivity/pressure_error.h"
#include "fem/adaptivity/resource_limits.h"
#include "fem/contact_problem.h"
#include "fem/equilibrium.h"
#include "fem/last_mesh.h"
#include "fem/refinement_pass.h"
#include "fem/strength_pass.h"

namespace geneva::fem {

/// Finds the equilibrium of an instant on finer and finer meshes, until the peak contact pressure,
/// without contact the maxima of stress, are as accurate as asked or a limit is reached.
template <int dim>
class AccuracyLoop {
 public:
  AccuracyLoop(MPI_Comm communicator, const mesh::MeshData<dim>& mesh, const Problem<dim>& problem,
               const Settings& settings, const Progress<dim>& progress);

  /// As solve_contact().
  Solution<dim> run(const std::optional<Checkpoint<dim>>& start);

 private:
  void start_on_coarse_mesh();
  void iterate(const std::optional<Checkpoint<dim>>& start);
  bool solve();
  bool advance();
  void tell_load_step(std::size_t step, const LevelState& found);
  void record();
  bool make_next_mesh();
  std::optional<Stop> choose_refinement();
  std::optional<Stop> choose_for_contact();
  std::optional<Stop> choose_for_strength();
  std::optional<double> worth_refining();
  double take_strength_along(double growth);
  std::optional<double> worth_refining_for_strength();
  void take_result();
  void tell(Work work);
  void find_smooth_parts();
  void find_strength(std::size_t meshes_before);
  void estimate();
  void estimate_pressure();
  void save();
  void restore(const Checkpoint<dim>& start);
  void go_back_to_last_mesh();
  Solution<dim> finish();

  MPI_Comm communicator_;
  Settings settings_;
  Progress<dim> progress_;
  dealii::Timer timer_;
  ResourceLimits limits_;
  base::AllocationWatch allocations_;
  Solution<dim> solution_;
  std::optional<Equilibrium<dim>> equilibrium_;
  RefinementPass<dim> refinement_;
  StrengthPass<dim> strength_;
  State<dim> state_;                 ///< on the present mesh
  std::optional<LevelState> found_;  ///< on the last mesh that was solved
  PressureError error_;
  LastMesh<dim> last_mesh_;              ///< on one rank
  double seconds_before_ = 0.;           ///< of the runs that this one continues
  std::optional<Stop> contact_is_done_;  ///< why, where meshes are made for the stresses alone
  bool is_ahead_ = false;  ///< whether the mesh is finer than that of solution_.displacement
};

}  // namespace geneva::fem
