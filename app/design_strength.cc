#include "app/design_strength.h"

#include <fmt/format.h>

#include "api/design_strength.h"
#include "app/pace.h"
#include "app/solving_command.h"

namespace geneva::app {

int design_with_strength(const MPI_Comm communicator, const std::filesystem::path& case_directory,
                         const std::filesystem::path& output, mesh::Mesher* const mesher) {
  SolvingCommand command(communicator, case_directory, output);
  ProgressDisplay& progress = command.progress();
  Design found = design(command.given());
  progress.line(table({found}));
  const auto tell_notices = [&](const std::size_t from) {
    for (std::size_t i = from; i < found.notices.size(); ++i)
      progress.line("note: " + found.notices[i]);
  };
  tell_notices(0);
  const std::size_t told = found.notices.size();
  const Pace pace;
  progress.phase("solving the first wheels");
  add_strength(found, communicator, mesher, [&](const int done, const int of) {
    progress.line(
        fmt::format("wheel {} of {} solved{}", done, of,
                    pace.time_left(static_cast<std::size_t>(done), static_cast<std::size_t>(of))));
    if (done < of) progress.phase("solving the next wheels");
  });
  progress.line("\nthe wheel away from the contact, as drawn:\n" +
                post::strength_table(found.report, command.given().units));
  tell_notices(told);
  command.write([&](const std::filesystem::path& directory) { return write(found, directory); },
                "design.json, design.csv and report.html");
  return 0;
}

}  // namespace geneva::app
