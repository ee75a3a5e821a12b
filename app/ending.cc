#include "app/ending.h"

#include <atomic>
#include <chrono>
#include <mutex>
#include <new>
#include <thread>

#include "app/exit_code.h"
#include "base/undo.h"

namespace geneva::app {

namespace {

using Flag = std::atomic<FailureStage>;
static_assert(Flag::is_always_lock_free);

/// In memory that the ranks of a machine share.
struct SharedFlag {
  MPI_Win window = MPI_WIN_NULL;
  std::mutex mutex;  ///< of the pointer: the memory ends before the threads that look at it
  Flag* flag = nullptr;
  FailureStage last = FailureStage::none;  ///< known when the memory ended
};

/// One for the process, as signals are, whose thread looks at it.
SharedFlag& shared() {
  static auto* const one = new SharedFlag;
  return *one;
}

void note(const FailureStage stage) {
  const std::lock_guard held(shared().mutex);
  if (shared().flag != nullptr) *shared().flag = stage;
}

void set_flag(Flag* const flag) {
  const std::lock_guard held(shared().mutex);
  shared().flag = flag;
}

/// The rank that exits first makes the launcher interrupt the others, which must still know why.
void keep_what_is_known() {
  const std::lock_guard held(shared().mutex);
  shared().last = *shared().flag;
  shared().flag = nullptr;
}

void share_flag(const MPI_Comm communicator) {
  MPI_Comm machine = MPI_COMM_NULL;
  MPI_Comm_split_type(communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  int rank = 0;
  MPI_Comm_rank(machine, &rank);
  void* own = nullptr;
  MPI_Win_allocate_shared(rank == 0 ? sizeof(Flag) : 0, 1, MPI_INFO_NULL, machine, &own,
                          &shared().window);
  if (rank == 0) new (own) Flag(FailureStage::none);
  MPI_Barrier(machine);
  MPI_Aint size = 0;
  int unit = 0;
  void* of_first = nullptr;
  MPI_Win_shared_query(shared().window, 0, &size, &unit, &of_first);
  set_flag(static_cast<Flag*>(of_first));
  MPI_Comm_free(&machine);
}

/// Rank 0's thread for interruptions looks every tenth of a second.
void wait_until_undone() {
  for (int i = 0; i < 100 && failure_on_this_machine() == FailureStage::alone; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

constexpr int failure_tag = 1;

}  // namespace

FailureStage failure_on_this_machine() {
  const std::lock_guard held(shared().mutex);
  return shared().flag == nullptr ? shared().last : shared().flag->load();
}

bool knows_other_ranks() {
  const std::lock_guard held(shared().mutex);
  return shared().flag != nullptr;
}

bool begin_to_end_alone() {
  if (failure_on_this_machine() != FailureStage::none || !knows_other_ranks()) return false;
  note(FailureStage::alone);
  wait_until_undone();
  return true;
}

void note_that_all_is_undone() { note(FailureStage::undone); }

Ending::Ending(const MPI_Comm communicator) {
  MPI_Comm_rank(communicator, &rank_);
  MPI_Comm_size(communicator, &ranks_);
  if (ranks_ == 1) return;
  MPI_Comm_dup(communicator, &communicator_);
  share_flag(communicator_);
}

Ending::~Ending() {
  if (ranks_ == 1) return;
  keep_what_is_known();
  MPI_Win_free(&shared().window);
  MPI_Comm_free(&communicator_);
}

bool Ending::all_fail() const {
  if (ranks_ == 1) return true;
  // Ranks that find the same error do so at nearly the same time.
  constexpr std::chrono::seconds patience(2);
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibarrier(communicator_, &request);
  const auto end = std::chrono::steady_clock::now() + patience;
  int is_done = 0;
  while (is_done == 0 && std::chrono::steady_clock::now() < end) {
    MPI_Test(&request, &is_done, MPI_STATUS_IGNORE);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return is_done != 0;
}

void Ending::tell_others() const {
  for (int other = rank_ + 1; other < ranks_; ++other) {
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Isend(nullptr, 0, MPI_INT, other, failure_tag, communicator_, &request);
    MPI_Request_free(&request);
  }
}

bool Ending::a_lower_rank_fails() const {
  int is_told = 0;
  MPI_Iprobe(MPI_ANY_SOURCE, failure_tag, communicator_, &is_told, MPI_STATUS_IGNORE);
  return is_told != 0;
}

void Ending::fail(const int code, const std::string& text) {
  tell_others();
  const bool together = all_fail();
  const bool speaks = together ? rank_ == 0 : !a_lower_rank_fails();
  if (speaks) {
    say_failure(code, text);
    note(together ? FailureStage::said : FailureStage::alone);
  }
  if (together) return;
  if (!speaks) std::this_thread::sleep_for(std::chrono::seconds(10));  // to be ended by the other
  wait_until_undone();
  if (failure_on_this_machine() != FailureStage::undone) base::undo_all();
  MPI_Abort(communicator_, code);
}

}  // namespace geneva::app
