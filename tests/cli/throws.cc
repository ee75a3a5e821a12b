// Loaded before a program (LD_PRELOAD), throws in the collective call of MPI with the number
// GENEVA_THROW_AT an exception of the kind GENEVA_THROW (failure_kinds.h). GENEVA_THROW_COUNT names
// a file to which every process adds the number of such calls in its end.
//
// Not among these calls are those by which ranks agree on their end (app/ending.cc), and those of
// libraries in C, through which no exception ever passes. If the call is one that no exception may
// leave, it is the next one that may.

#include <dlfcn.h>
#include <mpi.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "tests/cli/call_stack.h"
#include "tests/cli/failure_kinds.h"

namespace {

std::atomic<long> calls{0};

bool is_in_c(const void* const code) {
  Dl_info info;
  if (::dladdr(code, &info) == 0) return true;
  for (const char* const library : {"libp4est", "libsc", "libhdf5", "libmpi", "/mca_"})
    if (std::strstr(info.dli_fname, library) != nullptr) return true;
  return false;
}

/// Guards of deal.II's consensus algorithms wait for all ranks on the way out of them; what can
/// really fail there is an allocation.
bool may_throw(const std::string& kind) {
  return !is_where_nothing_may_fail() && (kind == "memory" || !is_within({"ConsensusAlgorithms"}));
}

void count(const void* const caller) {
  static const char* const at = std::getenv("GENEVA_THROW_AT");
  static const char* const kind = std::getenv("GENEVA_THROW");
  if (is_in_c(caller)) return;
  static long wanted = at == nullptr ? -1 : std::atol(at);
  if (++calls != wanted || kind == nullptr) return;
  if (!may_throw(kind))
    ++wanted;
  else
    failure_kinds().at(kind)();
}

struct Report {
  ~Report() {
    const char* const file = std::getenv("GENEVA_THROW_COUNT");
    if (file == nullptr) return;
    if (std::FILE* const stream = std::fopen(file, "a")) {
      std::fprintf(stream, "%ld\n", calls.load());
      std::fclose(stream);
    }
  }
} report;

}  // namespace

#define WRAP(name, parameters, arguments)                                                    \
  extern "C" int name parameters {                                                           \
    static const auto real = reinterpret_cast<int(*) parameters>(::dlsym(RTLD_NEXT, #name)); \
    count(__builtin_return_address(0));                                                      \
    return real arguments;                                                                   \
  }

WRAP(MPI_Allreduce, (const void* in, void* out, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm),
     (in, out, n, type, op, comm))
WRAP(MPI_Bcast, (void* data, int n, MPI_Datatype type, int root, MPI_Comm comm),
     (data, n, type, root, comm))
WRAP(MPI_Exscan, (const void* in, void* out, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm),
     (in, out, n, type, op, comm))
WRAP(MPI_Allgather,
     (const void* in, int n, MPI_Datatype type, void* out, int m, MPI_Datatype to, MPI_Comm comm),
     (in, n, type, out, m, to, comm))
WRAP(MPI_Gather,
     (const void* in, int n, MPI_Datatype type, void* out, int m, MPI_Datatype to, int root,
      MPI_Comm comm),
     (in, n, type, out, m, to, root, comm))
