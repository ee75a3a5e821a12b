#include "mesh/msh_file.h"

#include "base/errors.h"
#include "tests/fuzz/reader.h"

// What is looked at in a .msh file before Gmsh gets it.

int LLVMFuzzerTestOneInput(const std::uint8_t* const data, const std::size_t size) {
  try {
    geneva::mesh::check_msh(geneva::fuzz::text_of(data, size), "geometry.msh");
  } catch (const geneva::base::InputError&) {  // a refusal, in words
  }
  return 0;
}
