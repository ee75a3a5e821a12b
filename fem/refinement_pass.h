#pragma once

#include <optional>
#include <vector>

#include "fem/adaptivity/pressure_error.h"
#include "fem/adaptivity/refinement.h"
#include "fem/discretisation/vector.h"
#include "fem/equilibrium.h"

namespace geneva::fem {

/// From one mesh to the next: what is worth refining, and the refinement.
template <int dim>
class RefinementPass {
 public:
  RefinementPass(const mesh::MeshData<dim>& mesh, const Problem<dim>& problem,
                 const Settings& settings);

  /// Goes on from a checkpoint.
  void restore(const Checkpoint<dim>& start);

  /// Flags what is worth more: the contact zone until its part of the error is small, then the
  /// cells around it. In 3-D, where the zone takes most of the cells, the latter once before.
  /// @param found on this mesh
  /// @param history levels so far, the newest last
  /// @return by what the number of cells grows; nothing if no cell around the contact is larger
  /// than asked for, and only the zone's part of the error is left
  std::optional<double> choose(const Equilibrium<dim>& equilibrium, const LevelState& found,
                               const std::vector<LevelRecord>& history, const PressureError& error);

  /// Leaves it at the cells that have been flagged.
  /// @return by what the number of cells grows
  double choose_flagged(unsigned int flagged, const std::vector<LevelRecord>& history);

  /// By how much further flagged cells make the number of cells grow.
  static double growth_by_flagged(unsigned int flagged, const std::vector<LevelRecord>& history);

  /// Takes further flagged cells along, for the stresses away from the contacts.
  void take_along(unsigned int flagged) { state_.cells_beside += ((1U << dim) - 1U) * flagged; }

  /// Refines the flagged cells; while the load still acts on single nodes, whose pressure is of no
  /// use, the zone around them is refined once more before the next solve.
  State<dim> refine(Equilibrium<dim>& equilibrium, const LevelState& found, State<dim> now,
                    const std::vector<LevelRecord>& history);

  /// A node's gap is a mean over its edges: on long edges a contact may look open. The zone is
  /// refined until that gap is the one between the surfaces: three meshes with the same, since a
  /// refinement may change it little by chance.
  /// @throws base::InputError if it is open indeed
  State<dim> refine_open_contact(Equilibrium<dim>& equilibrium, const LevelState& found,
                                 State<dim> now, const std::vector<LevelRecord>& history,
                                 double length);

  /// Whether the contact has become wider than the zone that was refined: edges of very different
  /// lengths, whose pressure is of no use, and that can be made more equal.
  [[nodiscard]] bool has_spread(const Level<dim>& level) const;

  /// What the mesh has finer than the one before, put into its record.
  void record(LevelRecord& record) const;

  [[nodiscard]] const RefinementState& state() const { return state_; }
  [[nodiscard]] double grading() const { return grading_; }
  [[nodiscard]] const SurfaceIds& surface_ids() const { return surface_ids_; }

 private:
  double flag(const Equilibrium<dim>& equilibrium, const Vector& displacement,
              const std::vector<LevelRecord>& history) const;
  double level_off(const Equilibrium<dim>& equilibrium, const std::vector<LevelRecord>& history);
  bool surroundings_come_first(const Equilibrium<dim>& equilibrium, const LevelState& found,
                               const std::vector<LevelRecord>& history, const PressureError& error);
  State<dim> grade(Equilibrium<dim>& equilibrium, State<dim> now,
                   const std::vector<LevelRecord>& history) const;
  State<dim> make_zones_even(Equilibrium<dim>& equilibrium, State<dim> now) const;

  Problem<dim> problem_;
  Settings settings_;
  SurfaceIds surface_ids_;
  RefinementState state_;
  Refined refined_ = Refined::nothing;  ///< by the last refinement
  unsigned int last_halvings_ = 0;      ///< of the contact's cells between the last two meshes
  double grading_;                      ///< maximum ratio of cell size to distance asked for
};

}  // namespace geneva::fem
