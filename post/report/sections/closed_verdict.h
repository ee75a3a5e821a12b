#pragma once

#include "post/report/results/results_directory.h"
#include "post/report/sections/report_part.h"

namespace geneva::post {

/// The answer of closed forms, of an estimate or else of the motion: greatest pressure and force in
/// large type, and the limits; nothing without either.
ReportPart closed_verdict_part(const ResultsDirectory& results);

}  // namespace geneva::post
