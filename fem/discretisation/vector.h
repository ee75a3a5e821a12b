#pragma once

#include <deal.II/lac/la_parallel_vector.h>

namespace geneva::fem {

/// Values at unknowns, each on the rank that owns it. With ghosts, a vector has room for some of
/// other ranks as well, which are read after update_ghost_values(). A copy has the room, but not
/// the values of ghosts.
using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

/// In place of an assignment, which keeps the ghosts of the vector that is assigned to if both have
/// the same unknowns of their own.
inline void replace(Vector& vector, Vector by) { vector.swap(by); }

/// The same values, with those of ghosts.
inline Vector with_ghosts(const Vector& values, const dealii::IndexSet& ghosts) {
  Vector result(values.locally_owned_elements(), ghosts, values.get_mpi_communicator());
  result.copy_locally_owned_data_from(values);
  result.update_ghost_values();
  return result;
}

/// The same values, without room for ghosts.
inline Vector without_ghosts(const Vector& values) {
  Vector result(values.locally_owned_elements(), values.get_mpi_communicator());
  result.copy_locally_owned_data_from(values);
  return result;
}

}  // namespace geneva::fem
