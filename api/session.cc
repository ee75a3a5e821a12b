#include "api/session.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/multithread_info.h>
#include <deal.II/base/thread_management.h>
#include <dlfcn.h>
#include <p4est.h>

#include <cstdlib>
#include <functional>
#include <vector>

namespace geneva {

namespace {

/// One thread a process: what goes in parallel are the ranks.
void use_one_thread() {
  // these libraries have read their environment variables when they were loaded: it is too late to
  // set them now
  for (const char* name : {"openblas_set_num_threads", "omp_set_num_threads"})
    if (void* function = dlsym(RTLD_DEFAULT, name)) reinterpret_cast<void (*)(int)>(function)(1);
  // CHOLMOD asks for four threads in each of its loops, whatever was set.
  if (void* function = dlsym(RTLD_DEFAULT, "omp_set_max_active_levels"))
    reinterpret_cast<void (*)(int)>(function)(0);
}

/// TBB's own start must not be the place where memory runs out.
void start_task_scheduler() {
  dealii::Threads::new_task(std::function<void()>([] {})).join();
}

/// A process that no launcher has started is alone: it needs no daemon, no network, and starts in
/// less than a fifth of the time. It needs no directory for others to find it either, which it
/// would share with other processes that are alone: one that ends takes it from one that starts.
/// Whatever the user has set stays. For the start of MPI alone, and not for what this process
/// starts later, an mpirun among it.
class KeptToThisProcess {
 public:
  KeptToThisProcess() {
    for (const char* const name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"})
      if (std::getenv(name) != nullptr) return;
    set("OMPI_MCA_ess_singleton_isolated", "1");
    set("OMPI_MCA_pml", "ob1");
    set("OMPI_MCA_btl", "self");
    set("OMPI_MCA_orte_create_session_dirs", "0");
  }
  ~KeptToThisProcess() {
    for (const char* const name : set_) ::unsetenv(name);
  }
  KeptToThisProcess(const KeptToThisProcess&) = delete;
  KeptToThisProcess& operator=(const KeptToThisProcess&) = delete;

 private:
  void set(const char* const name, const char* const value) {
    if (std::getenv(name) != nullptr) return;
    ::setenv(name, value, 0);
    set_.push_back(name);
  }

  std::vector<const char*> set_;
};

bool is_started() {
  int flag = 0;
  MPI_Initialized(&flag);
  return flag != 0;
}

}  // namespace

struct Session::Libraries {
  Libraries(int& argc, char**& argv) : mpi(argc, argv, 1) {}
  dealii::Utilities::MPI::MPI_InitFinalize mpi;
};

Session::Session(int& argc, char**& argv) {
  use_one_thread();
  if (is_started()) {
    dealii::MultithreadInfo::set_thread_limit(1);
    sc_init(MPI_COMM_WORLD, 0, 0, nullptr, SC_LP_SILENT);
    p4est_init(nullptr, SC_LP_SILENT);
  } else {
    const KeptToThisProcess kept;
    libraries_ = std::make_unique<Libraries>(argc, argv);
  }
  start_task_scheduler();
  dealii::deal_II_exceptions::disable_abort_on_exception();
}

Session::~Session() = default;

}  // namespace geneva
