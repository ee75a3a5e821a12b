#pragma once

#include "post/report/results/results_directory.h"
#include "post/report/sections/report_part.h"

namespace geneva::post {

/// Pressure and stress below the contact; in 3-D line load and pressure along the pin.
ReportPart contact_part(const ResultsDirectory& results);

/// Pressure and error mesh by mesh, and what it took.
ReportPart convergence_part(const ResultsDirectory& results);

}  // namespace geneva::post
