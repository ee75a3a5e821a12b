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
  /// @param before those on the mesh before, see LevelRecord::strength; may be empty
  std::vector<BodyStrength<dim>> find(const Solution<dim>& solution,
                                      const std::vector<double>& before);

  /// Whether an error is greater than wanted.
  [[nodiscard]] bool is_open(const std::vector<BodyStrength<dim>>& strength) const;

  /// Flags the cells of bodies whose errors are greater than wanted; the more, the less it helped
  /// before. Those found on this mesh must be `solution`'s.
  /// @return number of flagged cells on all ranks
  unsigned int flag(const Solution<dim>& solution);

  /// Before the mesh changes.
  void forget_stress() { stress_.reset(); }

 private:
  [[nodiscard]] bool is_open(const BodyStrength<dim>& body) const;

  std::optional<double> accuracy_;
  std::vector<SingularPlace<dim>> singular_;
  double share_of_maximum_;
  std::optional<NodalStress<dim>> stress_;
};

/// The values alone: von Mises and tensile stress by body.
template <int dim>
std::vector<double> values_of(const std::vector<BodyStrength<dim>>& strength);

}  // namespace geneva::fem
