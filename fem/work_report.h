#pragma once

namespace geneva::fem {

/// What takes time beside the active set's steps.
enum class Work {
  stresses,    ///< recovering them on a mesh that is solved, and its errors
  figures,     ///< what is kept of a mesh for the errors of the figures
  refinement,  ///< the next mesh
  results,     ///< all figures of the last mesh
  writing      ///< the files
};

/// Told on every rank where such work begins.
struct WorkReport {
  Work work;
  unsigned int dofs;  ///< of the mesh that it is done on
};

}  // namespace geneva::fem
