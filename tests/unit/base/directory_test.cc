#include "base/directory.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/private_directory.h"
#include "tests/support/refusal.h"

namespace geneva::base {
namespace {

namespace fs = std::filesystem;
using geneva::test::PrivateDirectory;
using loads::test::expect_refused;

TEST(Directory, EntriesAreSortedAndComplete) {
  const PrivateDirectory room;
  const fs::path b = room.write("b", "");
  const fs::path hidden = room.write(".hidden", "");
  const fs::path inner = room.write("a/inner", "");
  EXPECT_EQ(entries_of(room.path()), (std::vector<fs::path>{hidden, inner.parent_path(), b}));
}

TEST(Directory, OneThatIsNotThereIsRefused) {
  const PrivateDirectory room;
  expect_refused([&] { entries_of(room.path() / "nowhere"); }, {"cannot read", "nowhere"});
}

TEST(Directory, ATreeIsRemovedAndWhatItsLinksLeadToIsNot) {
  const PrivateDirectory room;
  const fs::path kept = room.write("kept/file", "");
  const fs::path tree = room.write("tree/deep/file", "").parent_path().parent_path();
  fs::create_directory_symlink(kept.parent_path(), tree / "link");
  EXPECT_TRUE(remove_tree(tree));
  EXPECT_FALSE(fs::exists(fs::symlink_status(tree)));
  EXPECT_TRUE(fs::exists(kept));
  EXPECT_TRUE(remove_tree(tree)) << "nothing is left of what is not there";
}

}  // namespace
}  // namespace geneva::base
