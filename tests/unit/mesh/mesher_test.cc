#include "mesh/mesher.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "base/errors.h"
#include "case_directory.h"

namespace geneva::mesh {
namespace {

/// What a mesher that runs these commands is said to have answered.
MesherAnswer answer_of(const std::string& commands) {
  const test::CaseDirectory directory;
  const auto program = directory.write("mesher", "#!/bin/sh\n" + commands + "\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const GeometryTask task{2, "/", "nothing.geo", FileKind::geometry, 0.};
  return Mesher(program).answer(task, {1e9, 20.});
}

/// The only error of such an answer.
std::string error_of(const std::string& commands) {
  const MesherAnswer answer = answer_of(commands);
  return answer.errors.size() == 1 ? answer.errors.front() : "not one error";
}

/// Prints a text and ends by a signal.
std::string ending(const std::string& text, const std::string& signal) {
  return "echo \"" + text + "\" >&2; kill -" + signal + " $$";
}

TEST(Mesher, ACrashIsSaidWithTheLastMessage) {
  EXPECT_EQ(error_of(ending("Info: meshing", "SEGV")),
            "Gmsh or its CAD kernel crashed (it read or wrote where it has no memory), its last "
            "message: Info: "
            "meshing");
  EXPECT_EQ(error_of("exit 3"), "Gmsh ended without a mesh");
}

TEST(Mesher, ACheckThatFailedIsNamedByItsPlaceAlone) {
  EXPECT_EQ(
      error_of(ending("mesher: ./Geo/Reader.cpp:57: int Reader::read(const std::string&): "
                      "Assertion 'p != nullptr' failed.",
                      "ABRT")),
      "Gmsh or its CAD kernel crashed (it found an error in itself), its last message: a check at "
      "Reader.cpp:57 failed");
}

TEST(Mesher, AnExceptionIsNotSaidInWordsOfCpp) {
  const std::string text = "terminate called after throwing an instance of 'std::out_of_range'";
  for (const std::string& last : {text, text + "\n  what():  vector::_M_range_check"})
    EXPECT_EQ(error_of(ending(last, "ABRT")),
              "Gmsh or its CAD kernel crashed (it found an error in itself)");
}

TEST(Mesher, MemoryThatRanOutIsALimit) {
  for (const char* const last : {"  what():  std::bad_alloc", "Out of memory"})
    EXPECT_THROW((void)answer_of(ending(last, "ABRT")), base::LimitReached) << last;
}

}  // namespace
}  // namespace geneva::mesh
