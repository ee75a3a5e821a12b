#include <gtest/gtest.h>

#include <cstdlib>

/// Every property is tried on at least 200 random cases, unless RC_PARAMS says otherwise (for
/// example to repeat a failure with the seed it printed).
int main(int argc, char** argv) {
  setenv("RC_PARAMS", "max_success=200", 0);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
