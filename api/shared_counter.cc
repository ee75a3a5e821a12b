#include "api/shared_counter.h"

namespace geneva::api {

namespace {

constexpr int keeper = 0;  // the rank that holds the number

}  // namespace

SharedCounter::SharedCounter(const MPI_Comm communicator) {
  int rank = 0;
  int ranks = 1;
  MPI_Comm_rank(communicator, &rank);
  MPI_Comm_size(communicator, &ranks);
  if (ranks == 1) return;
  long long* number = nullptr;
  MPI_Win_allocate(rank == keeper ? sizeof(long long) : 0, sizeof(long long), MPI_INFO_NULL,
                   communicator, &number, &window_.emplace());
  if (rank == keeper) {
    MPI_Win_lock(MPI_LOCK_EXCLUSIVE, keeper, 0, *window_);
    *number = 0;
    MPI_Win_unlock(keeper, *window_);
  }
  MPI_Barrier(communicator);
}

SharedCounter::~SharedCounter() {
  if (window_) MPI_Win_free(&*window_);
}

std::size_t SharedCounter::next() {
  if (!window_) return own_++;
  const long long one = 1;
  long long number = 0;
  MPI_Win_lock(MPI_LOCK_SHARED, keeper, 0, *window_);
  MPI_Fetch_and_op(&one, &number, MPI_LONG_LONG, keeper, 0, MPI_SUM, *window_);
  MPI_Win_unlock(keeper, *window_);
  return static_cast<std::size_t>(number);
}

}  // namespace geneva::api
