#pragma once

#include <mpi.h>

#include <functional>
#include <stdexcept>
#include <utility>

namespace geneva {

/// What is thrown on the ranks of a computation that something thrown on another one has ended.
class EndedByOtherRank : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs what may throw, such as a callback, on this rank and ends all ranks if it throws on one:
/// otherwise the others would wait for that one for ever. All ranks call it.
/// @throws what the task throws, unchanged; on the other ranks InputError, LimitReached and
/// std::bad_alloc as they were thrown, and EndedByOtherRank with the text of anything else
void end_together(MPI_Comm communicator, const std::function<void()>& task);

/// A callback that is told by end_together(); empty if it is empty on this rank, as it then is on
/// all.
template <typename... Arguments>
std::function<void(Arguments...)> told_together(const MPI_Comm communicator,
                                                std::function<void(Arguments...)> callback) {
  if (!callback) return {};
  return [communicator, callback = std::move(callback)](Arguments... arguments) {
    end_together(communicator, [&] { callback(arguments...); });
  };
}

}  // namespace geneva
