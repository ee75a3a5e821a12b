#pragma once

#include "mesh/private_directory.h"

namespace geneva::mesh::test {

/// A directory of its own for the files of one test; removed at the end.
using CaseDirectory = PrivateDirectory;

}  // namespace geneva::mesh::test
