#pragma once

namespace geneva::base {

/// From here on allocations that fail are counted before std::bad_alloc is thrown.
void count_failed_allocations();

/// Of this process, since then. Libraries may lose the exception: deal.II 9.4 keeps those of its
/// tasks for somebody who never asks, and goes on with what has not been made.
unsigned long failed_allocations() noexcept;

}  // namespace geneva::base
