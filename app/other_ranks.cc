#include "app/other_ranks.h"

#include <chrono>

#include "app/ending.h"
#include "app/launch.h"
#include "base/allocation.h"
#include "base/undo.h"

namespace geneva::app {

namespace {

/// What another rank's failure asks of this one, once.
void look_at_other_ranks(const bool is_first) {
  if (!is_first || failure_on_this_machine() != FailureStage::alone) return;
  base::undo_all();
  note_that_all_is_undone();
}

/// Sees a rank that waits for ever for the others, which wait for it: an allocation has failed on
/// it within a collective call of a library, whose guards wait for all ranks on the way out of it.
class DeadlockWatch {
 public:
  void look() {
    const auto now = std::chrono::steady_clock::now();
    if (!base::has_unsettled_allocation())
      settled_at_ = now;
    else if (now - settled_at_ > patience && begin_to_end_alone())
      end_for_memory();
  }

 private:
  /// A failed allocation is settled by the end of the mesh's solution at the latest.
  static constexpr std::chrono::seconds patience{30};

  std::chrono::steady_clock::time_point settled_at_ = std::chrono::steady_clock::now();
};

}  // namespace

OtherRanks other_ranks() {
  const bool is_first = is_launched_as_first_rank();
  const auto look = [is_first, deadlocks = DeadlockWatch()]() mutable {
    look_at_other_ranks(is_first);
    deadlocks.look();
  };
  // Before the ranks know each other the launcher interrupts them where one has failed and said so.
  const auto speaks = [is_first, has_others = is_launched_with_others()] {
    return is_first && failure_on_this_machine() == FailureStage::none &&
           (!has_others || knows_other_ranks());
  };
  return {look, speaks};
}

}  // namespace geneva::app
