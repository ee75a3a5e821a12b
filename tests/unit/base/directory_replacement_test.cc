#include "base/directory_replacement.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <climits>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "base/errors.h"
#include "base/output_file.h"
#include "tests/support/private_directory.h"
#include "tests/support/refusal.h"

namespace geneva::base {
namespace {

namespace fs = std::filesystem;
using geneva::test::PrivateDirectory;
using loads::test::expect_refused;
using Names = std::set<std::string>;

std::string content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

Names names_in(const fs::path& directory) {
  Names names;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory))
    names.insert(entry.path().filename().string());
  return names;
}

ino_t number_of(const fs::path& file) {
  struct stat found {};
  return ::stat(file.c_str(), &found) == 0 ? found.st_ino : 0;
}

/// A directory with a directory of results in it.
class DirectoryReplacementTest : public testing::Test {
 protected:
  [[nodiscard]] const fs::path& room() const { return room_.path(); }
  [[nodiscard]] const fs::path& results() const { return results_; }
  [[nodiscard]] fs::path write(const std::string& name, const std::string& content) const {
    return room_.write(name, content);
  }

 private:
  PrivateDirectory room_;
  fs::path results_ = room_.write("results/old", "old").parent_path();
};

TEST_F(DirectoryReplacementTest, WithoutCommitEverythingIsAsItWas) {
  {
    const DirectoryReplacement replacement(results());
    write_text(replacement.working() / "new", "new");
    EXPECT_EQ(names_in(results()), Names{"old"});
  }
  EXPECT_EQ(names_in(room()), Names{"results"});
  EXPECT_EQ(names_in(results()), Names{"old"});
}

TEST_F(DirectoryReplacementTest, CommitReplacesAllFilesAndLeavesNothingBeside) {
  {
    DirectoryReplacement replacement(results());
    write_text(replacement.working() / "new", "new");
    replacement.commit();
  }
  EXPECT_EQ(names_in(room()), Names{"results"});
  EXPECT_EQ(names_in(results()), Names{"new"});
}

TEST_F(DirectoryReplacementTest, AFileThatIsNotOursStays) {
  const fs::path notes = write("results/notes", "the user's");
  const ino_t before = number_of(notes);
  DirectoryReplacement replacement(results());
  replacement.keep([](const std::string& name) { return name == "notes"; });
  replacement.commit();
  EXPECT_EQ(names_in(results()), Names{"notes"});
  EXPECT_EQ(content_of(notes), "the user's");
  EXPECT_EQ(number_of(notes), before);
}

TEST_F(DirectoryReplacementTest, AFileThatIsWrittenAnewIsNotKept) {
  DirectoryReplacement replacement(results());
  write_text(replacement.working() / "old", "new");
  replacement.keep([](const std::string&) { return true; });
  replacement.commit();
  EXPECT_EQ(content_of(results() / "old"), "new");
}

TEST_F(DirectoryReplacementTest, DirectoriesAndLinksMoveOver) {
  const fs::path inner = write("results/pictures/one", "picture");
  fs::create_symlink("nowhere", results() / "link");
  DirectoryReplacement replacement(results());
  replacement.commit();
  EXPECT_EQ(names_in(results()), (Names{"link", "pictures"}));
  EXPECT_EQ(content_of(inner), "picture");
}

TEST_F(DirectoryReplacementTest, ParentsAreMadeAndGoWithoutCommit) {
  const fs::path deep = room() / "a" / "b" / "results";
  {
    const DirectoryReplacement replacement(deep);
    EXPECT_TRUE(fs::is_directory(deep.parent_path()));
  }
  EXPECT_EQ(names_in(room()), Names{"results"});
  DirectoryReplacement replacement(deep);
  replacement.commit();
  EXPECT_TRUE(fs::is_directory(deep));
}

TEST_F(DirectoryReplacementTest, ASecondOneAtTheSameTimeIsRefused) {
  const DirectoryReplacement first(results());
  write_text(first.working() / "new", "new");
  expect_refused([&] { const DirectoryReplacement second(results()); }, {"another run"});
  EXPECT_EQ(names_in(first.working()), Names{"new"});
}

TEST_F(DirectoryReplacementTest, WhatAKillBetweenTwoRenamesLeftIsMended) {
  fs::rename(results(), room() / ".results.old");
  (void)write(".results.partial/half", "half");
  { const DirectoryReplacement replacement(results()); }
  EXPECT_EQ(names_in(room()), Names{"results"});
  EXPECT_EQ(names_in(results()), Names{"old"});
}

TEST_F(DirectoryReplacementTest, AnInterruptionPutsAwayWhatIsHalfDone) {
  const auto end = [&] {
    const DirectoryReplacement replacement(results());
    write_text(replacement.working() / "new", "new");
    undo_all();
    _exit(names_in(room()) == Names{"results"} ? 0 : 1);
  };
  EXPECT_EXIT(end(), testing::ExitedWithCode(0), "");
  EXPECT_EQ(names_in(results()), Names{"old"});
}

TEST_F(DirectoryReplacementTest, ALinkStandsForWhereItLeads) {
  fs::create_directory_symlink(results(), room() / "link");
  EXPECT_EQ(resolved(room() / "link"), results());
  EXPECT_EQ(working_directory_of(room() / "link" / "inner"), results() / ".inner.partial");
  {
    DirectoryReplacement replacement(room() / "link");
    replacement.commit();
  }
  EXPECT_EQ(names_in(room()), (Names{"link", "results"}));
  EXPECT_EQ(names_in(results()), Names{});
}

TEST_F(DirectoryReplacementTest, WhatCannotBeReplacedIsRefusedBeforeAnythingIsMade) {
  fs::create_symlink("nowhere", room() / "dangling");
  const std::string long_name(NAME_MAX - 10, 'n');
  expect_refused([&] { check_replaceable(results() / "old"); }, {"a file of that name"});
  expect_refused([&] { check_replaceable(results() / "old" / "deeper"); }, {"a file of that name"});
  expect_refused([&] { check_replaceable(room() / "dangling"); }, {"a link that leads to nothing"});
  expect_refused([&] { check_replaceable(room() / long_name); }, {"a name in it has 245 bytes"});
  expect_refused([&] { check_replaceable("/"); }, {"a file system of its own"});
  expect_refused([&] { check_replaceable("/proc"); }, {"a file system of its own"});
  expect_refused([&] { check_replaceable(fs::current_path()); }, {"the current directory"});
  EXPECT_EQ(names_in(room()), (Names{"dangling", "results"}));
}

}  // namespace
}  // namespace geneva::base
