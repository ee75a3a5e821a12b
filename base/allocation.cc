#include "base/allocation.h"

#include <atomic>
#include <new>

namespace geneva::base {

namespace {

/// The process has one handler.
std::atomic<unsigned long> failures{0};
std::atomic<unsigned long> settled{0};

[[noreturn]] void count() {
  ++failures;
  throw std::bad_alloc();
}

}  // namespace

void count_failed_allocations() { std::set_new_handler(count); }

unsigned long failed_allocations() noexcept { return failures; }

bool has_unsettled_allocation() noexcept { return failures > settled; }

void AllocationWatch::forget() {
  known_ = failures;
  settled = known_;
}

void AllocationWatch::require_none() {
  const bool is_all_known = known_ == failed_allocations();
  forget();
  if (!is_all_known) throw std::bad_alloc();
}

}  // namespace geneva::base
