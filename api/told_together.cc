#include "api/told_together.h"

#include <exception>
#include <new>

#include "base/errors.h"
#include "model/together.h"

namespace geneva {

void end_together(const MPI_Comm communicator, const std::function<void()>& task) {
  std::exception_ptr own;
  try {
    model::together(communicator, [&] {
      try {
        task();
      } catch (const std::exception&) {
        own = std::current_exception();
        throw;
      } catch (...) {
        own = std::current_exception();
        throw std::runtime_error("an exception that is none of the standard library's");
      }
    });
  } catch (const base::InputError&) {
    if (own) std::rethrow_exception(own);
    throw;
  } catch (const base::LimitReached&) {
    if (own) std::rethrow_exception(own);
    throw;
  } catch (const std::runtime_error& error) {
    if (own) std::rethrow_exception(own);
    throw EndedByOtherRank(error.what());
  } catch (const std::bad_alloc&) {
    if (own) std::rethrow_exception(own);
    throw;
  }
}

}  // namespace geneva
