#include "base/errors.h"
#include "mesh/geometry_check.h"
#include "tests/fuzz/reader.h"

// What is looked at in a .geo file before Gmsh gets it.

int LLVMFuzzerTestOneInput(const std::uint8_t* const data, const std::size_t size) {
  try {
    (void)geneva::mesh::check_geometry(geneva::fuzz::text_of(data, size), "geometry.geo");
  } catch (const geneva::base::InputError&) {  // a refusal, in words
  }
  return 0;
}
