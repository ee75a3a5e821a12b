#pragma once

#include "base/json_values.h"
#include "model/input/case_file.h"

namespace geneva::model {

/// What the documents of a case say that they are about, made now.
base::CaseHeader header_of(const Case& given);

}  // namespace geneva::model
