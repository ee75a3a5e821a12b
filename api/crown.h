#pragma once

#include <filesystem>
#include <string>

#include "api/case.h"
#include "api/written.h"
#include "post/output/crown_output.h"

namespace geneva {

/// The pin by which the line load of a case in 3-D is most even.
struct Crown {
  Case given;
  Case best;  ///< with the profile found, at its worst tilt, under the greatest force
  post::CrownReport report;
};

/// Searches for the crown radius (of a logarithmic profile: the amplitude) by which the maximum
/// line load along the pin of a case in 3-D is least, for all tilts that the case allows and under
/// its greatest load: by line contacts along the pin that half-spaces and a beam couple
/// (loads/pin/pin_line.h).
/// @throws InputError if the case is wrong, its pin has a tabulated profile, or those line contacts
/// know no answer
Crown design_crown(const Case& given);

/// The pin before and after as `geneva design --crown` prints it, in the case's units.
std::string table(const Crown& crown);

/// Writes crown.json, crown.csv, mechanism.json and the report. One rank calls it.
/// @throws InputError if the directory cannot be written; it is then as it was
Written write(const Crown& crown, const std::filesystem::path& directory);

}  // namespace geneva
