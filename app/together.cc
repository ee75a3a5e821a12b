#include "app/together.h"

#include <deal.II/base/mpi.h>

#include <boost/serialization/utility.hpp>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/errors.h"

namespace geneva::app {

void together(const MPI_Comm communicator, const std::function<void()>& task) {
  std::string refusal;
  std::string limit;
  const auto text_of = [](const std::exception& error) {
    const std::string text = error.what();
    return text.empty() ? "unknown error" : text;
  };
  try {
    task();
  } catch (const base::LimitReached& error) {
    limit = text_of(error);
  } catch (const std::exception& error) {
    refusal = text_of(error);
  }
  const std::pair own(refusal, limit);
  for (const auto& [refused, met] : dealii::Utilities::MPI::all_gather(communicator, own)) {
    if (!refused.empty()) throw std::invalid_argument(refused);
    if (!met.empty()) throw base::LimitReached(met);
  }
}

}  // namespace geneva::app
