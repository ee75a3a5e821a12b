#pragma once

#include "tests/support/private_directory.h"

namespace geneva::mesh::test {

/// A directory of its own for the files of one test; removed at the end.
using CaseDirectory = geneva::test::PrivateDirectory;

}  // namespace geneva::mesh::test
