#include "base/allocation.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <new>

namespace geneva::base {
namespace {

TEST(Allocation, ThatFailsIsCountedAndThrows) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer ends the process instead of throwing std::bad_alloc";
#endif
  const std::new_handler before = std::get_new_handler();
  count_failed_allocations();
  const unsigned long failures = failed_allocations();
  void* got = nullptr;
  // Half of all addresses are nobody's.
  EXPECT_THROW(got = ::operator new(std::numeric_limits<std::size_t>::max() / 2), std::bad_alloc);
  EXPECT_EQ(failed_allocations(), failures + 1);
  EXPECT_EQ(::operator new(std::numeric_limits<std::size_t>::max() / 2, std::nothrow), nullptr);
  EXPECT_EQ(failed_allocations(), failures + 2);
  ::operator delete(got);
  AllocationWatch watch;
  EXPECT_NO_THROW(watch.require_none());
  EXPECT_EQ(::operator new(std::numeric_limits<std::size_t>::max() / 2, std::nothrow), nullptr);
  EXPECT_TRUE(has_unsettled_allocation());
  EXPECT_THROW(watch.require_none(), std::bad_alloc);
  EXPECT_FALSE(has_unsettled_allocation());
  EXPECT_NO_THROW(watch.require_none()) << "it has been told";
  std::set_new_handler(before);
}

}  // namespace
}  // namespace geneva::base
