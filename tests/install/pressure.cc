#include <geneva/api/geneva.h>

#include <cstdio>
#include <exception>

/// Prints the peak pressure of each case, and writes the results of the last one.
int main(int argc, char** argv) try {
  const geneva::Session session(argc, argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  for (int i = 1; i + 1 < argc; ++i) {
    const geneva::Case given = geneva::read_case(argv[i]);
    const geneva::Analysis analysis = geneva::analyse(given, MPI_COMM_WORLD);
    const geneva::Fields fields = geneva::fields(analysis);
    const geneva::Contact& contact = analysis.contacts.front();
    double stress = 0.;
    for (const double value : fields.von_mises) stress = value > stress ? value : stress;
    double maximum = 0.;
    MPI_Allreduce(&stress, &maximum, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    if (rank == 0)
      std::printf("%.17g %.17g %zu %.17g %d\n", contact.peak_pressure, analysis.error,
                  analysis.meshes.size(), maximum, analysis.is_converged ? 1 : 0);
    if (i + 2 == argc) geneva::write(analysis, argv[argc - 1]);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
