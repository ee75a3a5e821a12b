#include "app/threads.h"

#include <deal.II/base/thread_management.h>
#include <dlfcn.h>

#include <functional>
#include <initializer_list>

namespace geneva::app {

void use_one_thread() {
  // these libraries have read their environment variables when they were loaded: it is too late to
  // set them now
  for (const char* name : {"openblas_set_num_threads", "omp_set_num_threads"})
    if (void* function = dlsym(RTLD_DEFAULT, name)) reinterpret_cast<void (*)(int)>(function)(1);
  // CHOLMOD asks for four threads in each of its loops, whatever was set.
  if (void* function = dlsym(RTLD_DEFAULT, "omp_set_max_active_levels"))
    reinterpret_cast<void (*)(int)>(function)(0);
}

void start_task_scheduler() {
  dealii::Threads::new_task(std::function<void()>([] {})).join();
}

}  // namespace geneva::app
