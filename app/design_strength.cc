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
  const auto tell_notices = [&](const std::size_t from) {
    for (std::size_t i = from; i < found.notices.size(); ++i)
      progress.line("note: " + found.notices[i]);
  };
  tell_notices(0);
  const std::size_t told = found.notices.size();
  add_strength(found, communicator, mesher, [&](const int done, const int of) {
    progress.line(fmt::format("wheel {} of {} solved", done, of));
  });
  progress.line("\nthe wheel away from the contact, as drawn:\n" +
                post::strength_table(found.report, given.units));
  tell_notices(told);
  Written written;
  model::together(communicator, [&] {
    if (is_first) written = write(found, directory);
  });
  tell_written(written, "design.json, design.csv and report.html", directory,
               [&](const std::string& line) { progress.line(line); });
  return 0;
}

}  // namespace geneva::app
