#include "app/surfaces.h"

#include <iostream>

#include "api/surfaces.h"
#include "app/commands.h"

namespace geneva::app {

int surfaces_of_case(const std::filesystem::path& case_directory, mesh::Mesher* const mesher) {
  if (mesher == nullptr) return 0;
  const SurfaceList list = surfaces(case_directory, *mesher);
  std::cout << shown_path(list.file) << '\n' << table(list);
  return 0;
}

}  // namespace geneva::app
