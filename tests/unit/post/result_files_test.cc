#include "post/output/result_files.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>

namespace geneva::post {
namespace {

TEST(OwnFile, IsOneOfTheList) {
  for (const char* name : {"summary.json", "contact.csv", "solution.12.vtu", "case.prm",
                           "kinematics.csv", "synthesis.json", "mechanism.json", "report.html"})
    EXPECT_EQ(own_file("there", name), std::filesystem::path("there") / name);
}

TEST(OwnFile, IsRefusedUnlessItIsListed) {
  for (const char* name :
       {"notes.txt", "solution.vtu", "solution..vtu.bak", "summary", "contact.json"})
    EXPECT_THROW(own_file("there", name), std::logic_error) << name;
}

TEST(ResultFiles, BelongToOneDocumentEach) {
  std::set<std::string> names;
  for (const ResultFiles& files : result_files()) {
    EXPECT_TRUE(names.insert(std::string(files.document) + ".json").second) << files.document;
    for (const char* table : files.tables)
      EXPECT_TRUE(names.insert(std::string(table) + ".csv").second) << table;
    for (const char* other : files.others) EXPECT_TRUE(names.insert(other).second) << other;
  }
  for (const std::string& name : names) {
    int owners = is_shared_file(name) ? 1 : 0;
    for (const ResultFiles& files : result_files()) owners += belongs_to(files, name) ? 1 : 0;
    EXPECT_EQ(owners, 1) << name;
  }
}

}  // namespace
}  // namespace geneva::post
