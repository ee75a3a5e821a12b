#include "base/output_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "base/errors.h"
#include "tests/support/private_directory.h"
#include "tests/support/refusal.h"

namespace geneva::base {
namespace {

namespace fs = std::filesystem;
using geneva::test::PrivateDirectory;
using loads::test::expect_refused;

std::string content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::ptrdiff_t entries_in(const fs::path& directory) {
  return std::distance(fs::directory_iterator(directory), fs::directory_iterator());
}

TEST(OutputFile, ATextArrivesWhole) {
  const PrivateDirectory directory;
  const std::string text("two\nlines, and \0 between", 24);
  write_text(directory.path() / "file", text);
  EXPECT_EQ(content_of(directory.path() / "file"), text);
}

TEST(OutputFile, WhatCannotBeOpenedIsNamedWithTheReason) {
  expect_refused([] { (void)open_output("/nowhere/file"); },
                 {"cannot write /nowhere/file: No such file or directory"});
}

TEST(OutputFile, AFullDiskIsSeenAtTheLatestWhenClosing) {
  std::ofstream stream = open_output("/dev/full");
  stream << "text";
  expect_refused([&] { close_output(stream, "/dev/full"); },
                 {"cannot write all of /dev/full: No space left on device"});
}

TEST(OutputFile, TheReasonIsLeftOutWhereThereIsNone) {
  errno = 0;
  EXPECT_EQ(with_reason("cannot"), "cannot");
  errno = ENOENT;
  EXPECT_EQ(with_reason("cannot"), "cannot: No such file or directory");
}

TEST(ReplaceFile, TheNewTextStandsInItsPlaceAndNothingBeside) {
  const PrivateDirectory directory;
  const fs::path file = directory.write("file", "old and longer");
  replace_file(file, "new");
  EXPECT_EQ(content_of(file), "new");
  EXPECT_EQ(entries_in(directory.path()), 1);
}

TEST(ReplaceFile, OthersMayReadItAsAnyNewFile) {
  const PrivateDirectory directory;
  const mode_t before = ::umask(027);
  replace_file(directory.path() / "file", "text");
  ::umask(before);
  struct stat found {};
  ASSERT_EQ(::stat((directory.path() / "file").c_str(), &found), 0);
  EXPECT_EQ(found.st_mode & 0777U, 0640U);
}

TEST(ReplaceFile, ALinkIsReplacedAndNotFollowed) {
  const PrivateDirectory directory;
  const fs::path others = directory.write("others", "theirs");
  fs::create_symlink(others, directory.path() / "link");
  replace_file(directory.path() / "link", "ours");
  EXPECT_EQ(content_of(others), "theirs");
  EXPECT_FALSE(fs::is_symlink(directory.path() / "link"));
}

TEST(ReplaceFile, AFailureLeavesNothingBeside) {
  const PrivateDirectory directory;
  const fs::path inner = directory.write("place/inner", "kept");
  expect_refused([&] { replace_file(directory.path() / "place", "text"); },
                 {"cannot write", "place: Is a directory"});
  EXPECT_EQ(content_of(inner), "kept");
  EXPECT_EQ(entries_in(directory.path()), 1);
}

}  // namespace
}  // namespace geneva::base
