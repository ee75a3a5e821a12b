#include "fem/energy_account.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "fem/resultants.h"

namespace geneva::fem {

namespace {

using CellVectors = std::vector<dealii::Vector<double>>;

CellVectors displacements_by_cell(const CellSystems& cells, const Vector& displacement) {
  CellVectors values(cells.size());
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const CellSystems::Dofs& dofs = cells.dofs(cell);
    values[cell].reinit(static_cast<unsigned int>(dofs.size()));
    for (unsigned int i = 0; i < dofs.size(); ++i) values[cell][i] = displacement(dofs[i]);
  }
  return values;
}

/// u.K u/2 of this rank's cells.
double stored_in(const CellSystems& cells, const CellVectors& displacements) {
  double energy = 0.;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const dealii::Vector<double>& u = displacements[cell];
    energy += 0.5 * cells.stiffness(cell).matrix_norm_square(u);
  }
  return energy;
}

/// What contacts take from an instant to the next by pressure along the gaps and friction along the
/// slips.
/// @param before of the instant before; nullptr: nothing touched
template <int dim>
double released_by(const ContactInterface<dim>& interface, const ContactState& now,
                   const ContactState* const before) {
  double energy = 0.;
  for (std::size_t i = 0; i < interface.rows.size(); ++i) {
    const ContactRow<dim>& row = interface.rows[i];
    const double gap = before ? before->gap[i] : row.initial_gap / row.weight;
    const double pressure = before ? before->pressure[i] : 0.;
    double released = (pressure + now.pressure[i]) * (now.gap[i] - gap);
    for (std::size_t t = 0; t < row.frame.tangents.size(); ++t) {
      const double friction = before ? before->friction[i][t] : 0.;
      const double slip = before ? before->slip[i][t] : 0.;
      released += (friction + now.friction[i][t]) * (now.slip[i][t] - slip);
    }
    energy -= 0.5 * row.weight * released;
  }
  return energy;
}

}  // namespace

template <int dim>
typename EnergyAccount<dim>::Forces EnergyAccount<dim>::forces_of(const Level<dim>& level,
                                                                  const LevelState& found) {
  Forces forces;
  for (std::size_t cell = 0; cell < level.cells.size(); ++cell)
    forces.loads.push_back(level.cells.load(cell));
  const std::map<global_dof_index, double> contact = contact_forces(level, found);
  for (const global_dof_index dof : level.held) {
    const auto of_contact = contact.find(dof);
    forces.held.push_back(found.forces(dof) -
                          (of_contact == contact.end() ? 0. : of_contact->second));
  }
  return forces;
}

template <int dim>
typename EnergyAccount<dim>::Motion EnergyAccount<dim>::motion_of(const Level<dim>& level,
                                                                  const LevelState& found) {
  Motion motion{displacements_by_cell(level.cells, found.displacement), {}};
  for (const global_dof_index dof : level.held) motion.held.push_back(found.displacement(dof));
  return motion;
}

template <int dim>
Energy EnergyAccount<dim>::add(const Level<dim>& level, const LevelState& found) {
  Forces forces = forces_of(level, found);
  Motion motion = motion_of(level, found);
  double in_cells = 0.;
  for (std::size_t cell = 0; cell < motion.cells.size(); ++cell) {
    dealii::Vector<double> force = forces.loads[cell];
    dealii::Vector<double> step = motion.cells[cell];
    if (forces_) force += forces_->loads[cell];
    if (motion_) step -= motion_->cells[cell];
    in_cells += 0.5 * (force * step);
  }
  double at_held = 0.;
  for (std::size_t i = 0; i < motion.held.size(); ++i)
    at_held += 0.5 * (forces.held[i] + (forces_ ? forces_->held[i] : 0.)) *
               (motion.held[i] - (motion_ ? motion_->held[i] : 0.));
  const MPI_Comm communicator = found.displacement.get_mpi_communicator();
  energy_.work += dealii::Utilities::MPI::sum(in_cells, communicator) + at_held;
  energy_.stored = dealii::Utilities::MPI::sum(stored_in(level.cells, motion.cells), communicator);
  for (std::size_t i = 0; i < level.interfaces.size(); ++i)
    energy_.released += released_by(level.interfaces[i], found.contacts[i],
                                    contacts_.empty() ? nullptr : &contacts_[i]);
  energy_.greatest = std::max(
      {energy_.greatest, energy_.stored, std::abs(energy_.work), std::abs(energy_.released)});
  forces_ = std::move(forces);
  motion_ = std::move(motion);
  contacts_ = found.contacts;
  return energy_;
}

template class EnergyAccount<2>;
template class EnergyAccount<3>;

}  // namespace geneva::fem
