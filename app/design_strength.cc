#include "app/design_strength.h"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include "api/design_strength.h"
#include "app/commands.h"
#include "app/progress.h"
#include "base/directory_replacement.h"
#include "model/together.h"

namespace geneva::app {

int design_with_strength(const MPI_Comm communicator, const std::filesystem::path& case_directory,
                         const std::filesystem::path& output, mesh::Mesher* const mesher) {
  const bool is_first = dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
  const Case given = read_case(case_directory);
  const std::filesystem::path directory = results_of(given.directory, output);
  model::together(communicator, [&] {
    if (is_first) base::check_replaceable(directory);
  });
  ProgressDisplay progress(is_first, given.units);
  Design found = design(given);
  progress.line(table({found}));
  for (const std::string& notice : found.notices) progress.line("note: " + notice);
  add_strength(found, communicator, mesher, [&](const int done, const int of) {
    progress.line(fmt::format("wheel {} of {} solved", done, of));
  });
  progress.line("\nthe wheel away from the contact, as drawn:\n" +
                post::strength_table(found.report, given.units));
  Written written;
  model::together(communicator, [&] {
    if (is_first) written = write(found, directory);
  });
  warn_of_missing_packages(written);
  if (const std::string notice = removal_notice(written); !notice.empty()) progress.line(notice);
  progress.line("design.json, design.csv and report.html in " + shown_path(directory));
  return 0;
}

}  // namespace geneva::app
