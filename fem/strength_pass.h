#pragma once

#include <optional>
#include <vector>

#include "fem/singular_places.h"
#include "fem/solution.h"
#include "fem/stress_recovery.h"

namespace geneva::fem {

/// The maxima of stress outside of the contacts on every mesh, and the refinement that they need.
template <int dim>
class StrengthPass {
 public:
  /// @param accuracy wanted relative error of the maxima, > 0; nothing: they are not refined for
  StrengthPass(const mesh::MeshData<dim>& mesh, const Problem<dim>& problem,
               std::optional<double> accuracy);

  /// Recovers the stress on this mesh and finds the maxima.
  /// @param before the meshes before, the newest last; may be empty
  std::vector<BodyStrength<dim>> find(const Solution<dim>& solution,
                                      const std::vector<LevelRecord>& before);

  /// Flags the cells that count most of the maxima that are not as accurate as wanted. Those found
  /// on this mesh must be `solution`'s.
  /// @return number of flagged cells on all ranks
  unsigned int flag(const Solution<dim>& solution, MeshFor next) const;

  /// On the last mesh; nothing after forget_stress().
  [[nodiscard]] const std::optional<NodalStress<dim>>& stress() const { return stress_; }

  /// Places left out on the last mesh.
  [[nodiscard]] const std::vector<SingularPlace<dim>>& singular() const { return singular_; }

  /// Before the mesh changes.
  void forget_stress() { stress_.reset(); }

 private:
  /// Those whose error by the mesh is greater than wanted, and than what the choice of the
  /// contacts' own field leaves open, which no mesh lowers; beside a contact none that is minor or
  /// that this choice decides, nor one that does not stand clear of what is left out around
  /// singular places. Without contact both if any.
  [[nodiscard]] std::vector<const StressMaximum<dim>*> wanted(const BodyStrength<dim>& body) const;

  bool has_contact_;
  std::optional<double> accuracy_;
  mesh::MeshData<dim> mesh_;
  std::vector<SingularPlace<dim>> by_geometry_;
  std::vector<SingularPlace<dim>> singular_;  ///< those, and where stresses have grown
  std::optional<NodalStress<dim>> stress_;
};

/// Whether there is any.
template <int dim>
bool is_stressed(const std::vector<BodyStrength<dim>>& strength);

/// The greatest of their errors, at most 1.
template <int dim>
double maximum_error(const std::vector<BodyStrength<dim>>& strength);

/// What a history keeps of them.
template <int dim>
std::vector<StrengthRecord> record_of(const std::vector<BodyStrength<dim>>& strength);

}  // namespace geneva::fem
