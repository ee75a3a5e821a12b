#pragma once

#include <string>

#include "post/report/library.h"
#include "post/report/results_directory.h"

namespace geneva::post {

/// The report on a results directory: one HTML page that needs nothing besides itself.
/// @throws std::invalid_argument if a document lacks what its format promises
std::string report_html(const ResultsDirectory& results, const Libraries& libraries);

}  // namespace geneva::post
