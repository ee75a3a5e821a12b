#include "base/directory_lock.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "base/errors.h"
#include "tests/support/private_directory.h"
#include "tests/support/refusal.h"

namespace geneva::base {
namespace {

namespace fs = std::filesystem;
using geneva::test::PrivateDirectory;
using loads::test::expect_refused;

std::string first_line_of(const fs::path& file) {
  std::string line;
  std::ifstream stream(file);
  std::getline(stream, line);
  return line;
}

TEST(DirectoryLock, ASecondHolderIsRefusedAndToldOfTheFirst) {
  const PrivateDirectory directory;
  const DirectoryLock first(directory.path() / "lock", "results");
  expect_refused([&] { const DirectoryLock second(directory.path() / "lock", "results"); },
                 {"results: another run (process " + std::to_string(::getpid()) + ")"});
  EXPECT_TRUE(fs::exists(directory.path() / "lock"));
}

TEST(DirectoryLock, TheFileGoesWithTheLock) {
  const PrivateDirectory directory;
  { const DirectoryLock lock(directory.path() / "lock", "results"); }
  EXPECT_FALSE(fs::exists(directory.path() / "lock"));
  const DirectoryLock again(directory.path() / "lock", "results");
  EXPECT_EQ(first_line_of(directory.path() / "lock"), std::to_string(::getpid()));
}

TEST(DirectoryLock, TheFileOfADeadProcessDoesNotLock) {
  const PrivateDirectory directory;
  const fs::path file = directory.write("lock", "99999999 and more\n");
  const DirectoryLock lock(file, "results");
  EXPECT_EQ(first_line_of(file), std::to_string(::getpid()));
}

TEST(DirectoryLock, ALinkInItsPlaceIsNotFollowed) {
  const PrivateDirectory directory;
  const fs::path others = directory.write("others", "theirs");
  fs::create_symlink(others, directory.path() / "lock");
  expect_refused([&] { const DirectoryLock lock(directory.path() / "lock", "results"); },
                 {"results cannot be written beside"});
  EXPECT_EQ(first_line_of(others), "theirs");
}

TEST(DirectoryLock, AnInterruptionTakesTheFileAway) {
  const PrivateDirectory directory;
  const auto end = [&] {
    const DirectoryLock lock(directory.path() / "lock", "results");
    undo_all();
    _exit(fs::exists(directory.path() / "lock") ? 1 : 0);
  };
  EXPECT_EXIT(end(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace geneva::base
