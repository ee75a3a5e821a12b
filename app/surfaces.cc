#include "app/surfaces.h"

#include <iostream>

#include "api/surfaces.h"
#include "app/commands.h"

namespace geneva::app {

namespace fs = std::filesystem;

int surfaces_of_case(const fs::path& case_directory, const fs::path& output,
                     mesh::Mesher* const mesher) {
  if (mesher == nullptr) return 0;
  const SurfaceList list = surfaces(case_directory, *mesher);
  std::cout << shown_path(list.file) << '\n' << table(list);
  const fs::path beside =
      is_step_file(case_directory) ? case_directory.parent_path() : case_directory;
  const fs::path file = output.empty() ? beside / "surfaces.html" : output;
  write_picture(list, file);
  std::cout << "picture in " << shown_path(file) << '\n';
  return 0;
}

}  // namespace geneva::app
