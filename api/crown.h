#pragma once

#include <mpi.h>

#include <filesystem>
#include <functional>
#include <string>

#include "api/case.h"
#include "api/written.h"
#include "post/output/crown_output.h"

namespace geneva {

namespace mesh {
class Mesher;
}

/// The pin by which the line load of a case in 3-D is most even.
struct Crown {
  Case given;
  post::CrownReport report;
  bool is_accurate;  ///< whether both pins were solved as accurately as the case asks
};

/// What is told on every rank while it is searched for.
using Tell = std::function<void(const std::string&)>;

/// Searches for the crown radius (of a logarithmic profile: the amplitude) by which the line load
/// along the pin of a case in 3-D is most even. All ranks call it.
///
/// The search runs on coarse meshes; before and after are solved as accurately as the case asks.
/// @param tell may be empty
/// @param mesher already started, on rank 0; nothing: it is started when it is needed
/// @throws InputError on all ranks if the case is wrong or its pin has a tabulated profile
Crown design_crown(const Case& given, MPI_Comm communicator, const Tell& tell = {},
                   mesh::Mesher* mesher = nullptr);

/// The pin before and after as `geneva design --crown` prints it, in the case's units.
std::string table(const Crown& crown);

/// Writes crown.json, crown.csv, mechanism.json and the report. One rank calls it.
/// @throws InputError if the directory cannot be written; it is then as it was
Written write(const Crown& crown, const std::filesystem::path& directory);

}  // namespace geneva
