#pragma once

#include <mpi.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "api/case.h"
#include "api/written.h"
#include "fem/adaptivity/level_record.h"
#include "fem/step_report.h"
#include "fem/work_report.h"
#include "post/analysis/check.h"
#include "post/analysis/comparison_row.h"
#include "post/output/nodal_fields.h"

namespace geneva {

namespace mesh {
class Mesher;
}
namespace api {
struct AnalysisState;
}

/// A vector; z is 0 in the plane.
using Vector = std::array<double, 3>;

/// The state of a node of a source surface, SI units.
struct ContactPoint {
  Vector place;           ///< undeformed [m]
  double pressure;        ///< >= 0 [Pa]
  double gap;             ///< > 0 when open [m]
  double hertz_pressure;  ///< [Pa]; not a number where Hertz's theory does not hold
};

/// What one contact pair carries, SI units.
struct Contact {
  std::string source;
  std::string target;
  Vector force;          ///< resultant of the pressure on the source's body [N]
  double peak_pressure;  ///< [Pa]
  double half_width;     ///< [m]; in 3-D of the middle section, or the semi-axis across z
  std::vector<ContactPoint> points;
};

/// Displacement and stress on the cells of this rank, SI units.
using Fields = post::NodalFields;

/// What is told before the first mesh is solved.
struct AnalysisStart {
  std::string heading;               ///< the case, its mechanism and load
  std::vector<std::string> notices;  ///< what the user should know of the model
  /// Meshes that an earlier run has solved, with a checkpoint.
  std::vector<fem::LevelRecord> earlier;
};

/// Told of how far an analysis is, on every rank; each may be empty, on all ranks alike. What one
/// throws ends the analysis, see end_together().
struct Progress {
  std::function<void(const AnalysisStart&)> start;
  std::function<void(const fem::StepReport&)> step;   ///< of the active set
  std::function<void(const fem::LevelRecord&)> mesh;  ///< one that is solved
  std::function<void(const fem::WorkReport&)> work;   ///< what else begins, up to the writing
};

/// How an analysis may be left and gone on with.
struct Checkpointing {
  std::string start;                      ///< of an earlier analysis of the case; empty: none
  bool is_wanted = false;                 ///< the same on all ranks
  std::function<bool()> is_due;           ///< after a mesh, on rank 0
  std::function<void(std::string)> keep;  ///< a checkpoint, on rank 0
};

/// What analyse() may be told beside the case.
struct AnalysisOptions {
  Progress progress;
  Checkpointing checkpoints;
  mesh::Mesher* mesher = nullptr;  ///< already started, on rank 0; nothing: it is started when
                                   ///< it is needed
};

/// The contact problem of a case solved: figures with their errors, beside the closed forms.
struct Analysis {
  Case given;
  bool is_converged;              ///< whether the accuracy was reached that the case asks for
  std::string shortfall;          ///< what was reached instead, why, and what to try
  double error;                   ///< of the peak pressure, estimated, relative
  std::vector<Contact> contacts;  ///< by contact pair
  std::vector<fem::LevelRecord> meshes;
  std::vector<post::ComparisonRow> figures;  ///< with their errors, closed forms, published values
  std::vector<post::Check> checks;           ///< what must be small in a sound result
  std::vector<std::string> notices;  ///< what the user should know before trusting the figures
  std::string table;                 ///< the figures, as `geneva run` prints them
  double memory;                     ///< maximum resident meanwhile, all ranks [byte]
  std::shared_ptr<const api::AnalysisState> state;  ///< the finite-element solution
};

/// Solves the contact problem of a case by finite elements; prints and writes nothing. All ranks
/// call it, and all but the points of Fields is the same on all.
/// @throws InputError if the case cannot be solved
/// @throws LimitReached if a limit was reached before there was any result
Analysis analyse(const Case& given, MPI_Comm communicator, const AnalysisOptions& options = {});

/// The fields of an analysis on this rank's cells.
Fields fields(const Analysis& analysis);

/// What summary.json of `geneva run` says, without the time that writing takes.
nlohmann::json summary(const Analysis& analysis);

/// Writes the fields (VTU, HDF5), summary.json, contact.csv and the report, as `geneva run` does.
/// All ranks call it.
/// @throws InputError if the directory cannot be written; it is then as it was
Written write(const Analysis& analysis, const std::filesystem::path& directory);

}  // namespace geneva
