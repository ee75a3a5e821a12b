#pragma once

/// Geneva as a library: a case is read, computed, and written.
///
///     const geneva::Session session(argc, argv);
///     const geneva::Case given = geneva::read_case("cases/johnson-optimum-wheel");
///     const geneva::Analysis analysis = geneva::analyse(given, MPI_COMM_WORLD);
///     geneva::write(analysis, "results");

#include "api/analysis.h"
#include "api/case.h"
#include "api/crown.h"
#include "api/cycle.h"
#include "api/design.h"
#include "api/estimate.h"
#include "api/kinematics.h"
#include "api/report.h"
#include "api/session.h"
#include "api/synthesis.h"
#include "api/told_together.h"
#include "api/version.h"
