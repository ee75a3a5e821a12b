// What a contact analysis in 3-D costs, beside one plain linear elastic solve (cell matrices,
// assembly, multigrid and conjugate gradients to 1e-8 from zero) on its finest mesh with its final
// contact.
//
//   space_benchmark CASE_DIR ACCURACY...       also under mpirun
//
// One line for each accuracy: "0.05" is 5 %.

#include <malloc.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>
#include <deal.II/base/utilities.h>
#include <fmt/format.h>

#include <cstdlib>
#include <iostream>
#include <optional>

#include "api/session.h"
#include "fem/contact_problem.h"
#include "fem/level.h"
#include "fem/linear/constraints.h"
#include "fem/linear/linear_system.h"
#include "fem/problem/scaling.h"
#include "model/input/case_file.h"
#include "model/model.h"

namespace {

using namespace geneva;

/// The finest mesh's level with the final active sets.
fem::Level<3> finest_level(const fem::Solution<3>& solution) {
  std::optional<fem::SurfaceOrigins<3>> origins;
  fem::Level<3> level =
      fem::make_level(*solution.dof_handler, solution.mesh,
                      fem::scaled(solution.problem, solution.scales), solution.scales, origins);
  for (std::size_t i = 0; i < level.interfaces.size(); ++i)
    for (std::size_t j = 0; j < level.interfaces[i].rows.size(); ++j)
      level.interfaces[i].status[j] = solution.contacts[i].nodes[j].status;
  return level;
}

/// Of all ranks together, now, without what is free [bytes].
double memory_now() {
  malloc_trim(0);
  dealii::Utilities::System::MemoryStats memory{};
  dealii::Utilities::System::get_memory_stats(memory);
  return dealii::Utilities::MPI::sum(1024. * static_cast<double>(memory.VmRSS), MPI_COMM_WORLD);
}

/// One linear solve of the finest mesh.
struct PlainSolve {
  double assembly;  ///< [s]
  double set_up;    ///< of the preconditioner [s]
  double renewal;   ///< of it for another active set [s]
  double cycles;    ///< conjugate gradients [s]
  unsigned int iterations;
  double memory;  ///< of the preconditioner [bytes]

  [[nodiscard]] double seconds() const { return assembly + set_up + cycles; }
};

PlainSolve plain_solve(const fem::Solution<3>& solution, const fem::Method method) {
  const fem::Level<3> level = finest_level(solution);
  const auto& dof_handler = *solution.dof_handler;
  PlainSolve result{};
  dealii::Timer timer;
  const auto seconds = [&] {
    const double time = timer.wall_time();
    timer.restart();
    return time;
  };
  const auto cells = fem::cell_systems(dof_handler, fem::scaled(solution.problem, solution.scales),
                                       solution.mesh.surfaces);
  fem::LinearSystem<3> system(dof_handler, level.ghosts, fem::lasting_constraints(level), cells,
                              level.tie_forces);
  system.constrain(fem::constraints(level));
  result.assembly = seconds();
  const double memory = memory_now();
  system.set_up(dof_handler, method);
  result.set_up = seconds();
  result.memory = memory_now() - memory;
  system.constrain(fem::constraints(level));
  result.renewal = seconds();
  fem::Vector displacement(level.owned, MPI_COMM_WORLD);
  result.iterations = system.solve(displacement, 1e-8, 0.);
  result.cycles = seconds();
  return result;
}

void print(const char* const name, const PlainSolve& solve) {
  std::cout << fmt::format("    {:<6}{:>10.2f}{:>10.2f}{:>10.2f}{:>10.2f}{:>6}{:>10.0f}\n", name,
                           solve.assembly, solve.set_up, solve.renewal, solve.cycles,
                           solve.iterations, 1e-6 * solve.memory);
}

double peak_memory() {
  dealii::Utilities::System::MemoryStats memory{};
  dealii::Utilities::System::get_memory_stats(memory);
  return dealii::Utilities::MPI::sum(1024. * static_cast<double>(memory.VmHWM), MPI_COMM_WORLD);
}

void measure(const model::Case& given, const double accuracy, mesh::Mesher& mesher) {
  const model::Model<3> model = model::make_model<3>(MPI_COMM_WORLD, given, &mesher);
  fem::Settings settings = given.settings;
  settings.accuracy = accuracy;
  settings.max_memory = 24e9;
  settings.max_dofs = 5000000;
  const dealii::Timer timer;
  const fem::Solution<3> solution =
      fem::solve_contact(MPI_COMM_WORLD, model.mesh, model.problem, settings, {});
  const double total = timer.wall_time();
  const double memory = peak_memory();
  const auto& history = solution.history;
  const double finest =
      history.back().seconds - (history.size() > 1 ? history[history.size() - 2].seconds : 0.);
  const PlainSolve plain = plain_solve(solution, fem::Method::multigrid);
  const PlainSolve library = plain_solve(solution, fem::Method::library_multigrid);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0) return;
  std::cout << fmt::format(
      "{:>9}{:>8}{:>9.2f}{:>10.2f}{:>9.2f}{:>6}{:>9.2f}{:>9.2f}{:>12.1f}{:>9.2f}\n",
      history.back().dofs, history.back().linear_iterations.size(), total, finest, plain.seconds(),
      plain.iterations, total / plain.seconds(), finest / plain.seconds(),
      1e6 * total / history.back().dofs, memory / 1e9);
  std::cout << fmt::format("    {:<6}{:>10}{:>10}{:>10}{:>10}{:>6}{:>10}\n", "solver", "assembly",
                           "set-up", "renewal", "cycles", "CG", "mem [MB]");
  print("own", plain);
  print("ML", library);
  std::cout << std::flush;
}

}  // namespace

int main(int argc, char** argv) {
  const Session session(argc, argv);
  if (argc < 3) {
    std::cerr << "usage: space_benchmark CASE_DIR ACCURACY...\n";
    return 1;
  }
  const model::Case given = model::read_case(argv[1]);
  mesh::Mesher mesher(MESHER);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::cout << fmt::format("{:>9}{:>8}{:>9}{:>10}{:>9}{:>6}{:>9}{:>9}{:>12}{:>9}\n", "unknowns",
                             "steps", "all [s]", "finest[s]", "plain[s]", "CG", "all/pl.",
                             "fin./pl.", "us/unknown", "mem [GB]");
  for (int i = 2; i < argc; ++i) measure(given, std::atof(argv[i]), mesher);
  return 0;
}
