#pragma once

#include <array>
#include <vector>

namespace geneva::fem {

/// What a mesh has finer than the one before.
enum class Refined {
  nothing,      ///< the first mesh
  zone,         ///< the contact zone; the cells around keep their ratio of size to distance
  surroundings  ///< the cells around the contact, whose ratio of size to distance is halved
};

/// A maximum stress on a mesh.
struct StressRecord {
  double value;                 ///< [Pa]; 0 if there is no place for it
  std::array<double, 3> place;  ///< [m]; z is 0 in the plane
  bool is_round;                ///< whether the surface is round there
};

/// Those of a body away from the contacts.
struct StrengthRecord {
  StressRecord von_mises;
  StressRecord tensile;
};

/// One mesh of the nested iteration.
struct LevelRecord {
  unsigned int cells;
  unsigned int dofs;
  std::vector<unsigned int> linear_iterations;  ///< one entry for every active-set step
  double peak_pressure;                         ///< [Pa]
  Refined refined;
  double grading;         ///< maximum ratio of cell size to distance from the contact
  double size_measure;    ///< see there; of the error by the cells' sizes
  double energy_error;    ///< see there; where supports alone press, else 0
  double error_estimate;  ///< relative, of the peak pressure extrapolated from this mesh
  /// In 3-D: maximum pressure in the middle half of the surfaces' common length, and at its two
  /// ends [Pa].
  double mid_length_pressure;
  double end_pressure;
  std::vector<StrengthRecord> strength;  ///< by body
  unsigned int halvings;                 ///< of the contact's cells since the mesh before
  unsigned int active_nodes;
  unsigned int nodes_across;  ///< active nodes that the contacts are wide
  bool cycled;     ///< the active set came back to an earlier one; its nodes then could only close
  double seconds;  ///< since the start of the contact solve
  double one_solve_seconds;  ///< one assembly and one linear solve on this mesh
};

/// Pressure at the ends of a contact's length.
struct EdgePressure {
  bool is_bounded;
  double
      growth_exponent;  ///< gamma of p ~ h^-gamma over the last two meshes, h being the cell size
  double pressure;      ///< maximum beyond the middle half of the length [Pa]
};

}  // namespace geneva::fem
