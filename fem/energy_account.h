#pragma once

#include <deal.II/lac/vector.h>

#include <optional>
#include <vector>

#include "fem/active_set_iteration.h"
#include "fem/energy.h"
#include "fem/level.h"

namespace geneva::fem {

/// Keeps the account from instant to instant on one mesh. Forces change in proportion from one
/// instant to the next, so that (F0 + F1)/2 . (u1 - u0) is their work.
template <int dim>
class EnergyAccount {
 public:
  /// Of the next instant, in the units of the triangulation. Collective.
  Energy add(const Level<dim>& level, const LevelState& found);

 private:
  struct Forces {
    std::vector<dealii::Vector<double>> loads;  ///< by cell of this rank
    std::vector<double> held;                   ///< by dof of level.held
  };
  struct Motion {
    std::vector<dealii::Vector<double>> cells;  ///< displacements by cell of this rank
    std::vector<double> held;                   ///< by dof of level.held
  };

  [[nodiscard]] static Forces forces_of(const Level<dim>& level, const LevelState& found);
  [[nodiscard]] static Motion motion_of(const Level<dim>& level, const LevelState& found);

  Energy energy_;
  std::optional<Forces> forces_;  ///< at the last instant; none before the first
  std::optional<Motion> motion_;
  std::vector<ContactState> contacts_;
};

}  // namespace geneva::fem
