#pragma once

namespace geneva::base {

/// From here on allocations that fail are counted before std::bad_alloc is thrown.
void count_failed_allocations();

/// Of this process, since then. Libraries may lose the exception: deal.II 9.4 keeps those of its
/// tasks for somebody who never asks, and goes on with what has not been made.
unsigned long failed_allocations() noexcept;

/// Whether one has failed after the last one that an AllocationWatch of this process knows.
bool has_unsettled_allocation() noexcept;

/// Sees allocations that failed without anybody having been told.
class AllocationWatch {
 public:
  /// @throws std::bad_alloc if one has failed since the watch was made or asked last
  void require_none();

  /// What has failed until now is known.
  void forget();

 private:
  unsigned long known_ = failed_allocations();
};

}  // namespace geneva::base
