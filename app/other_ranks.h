#pragma once

#include "app/interruption.h"

namespace geneva::app {

/// How this rank ends with the others of a run: rank 0 puts away what is half done when one has
/// failed alone; a rank whose allocation has failed within a collective call of a library, so that
/// all wait for ever, ends them.
OtherRanks other_ranks();

}  // namespace geneva::app
