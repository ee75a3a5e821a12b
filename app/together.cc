#include "app/together.h"

#include <deal.II/base/mpi.h>

#include <stdexcept>
#include <string>

namespace geneva::app {

void together(const MPI_Comm communicator, const std::function<void()>& task) {
  std::string refusal;
  try {
    task();
  } catch (const std::exception& error) {
    refusal = error.what();
    if (refusal.empty()) refusal = "unknown error";
  }
  for (const std::string& text : dealii::Utilities::MPI::all_gather(communicator, refusal))
    if (!text.empty()) throw std::invalid_argument(text);
}

}  // namespace geneva::app
