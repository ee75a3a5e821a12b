#include "mesh/mesher.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/time.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/errors.h"
#include "case_directory.h"

namespace geneva::mesh {
namespace {

/// Takes the descriptors of one task, gives its own number as that of a copy, and becomes a shell
/// that runs the commands.
std::string one_task(const std::string& commands) {
  return "#!/usr/bin/python3\n"
         "import os, socket, struct\n"
         "control = socket.socket(fileno=0)\n"
         "message, (talk, messages), flags, address = socket.recv_fds(control, 1, 2)\n"
         "control.send(struct.pack('i', os.getpid()))\n"
         "for own in 1, 2: os.dup2(messages, own)\n"
         "os.execv('/bin/sh', ['sh', '-c', r\"\"\"" +
         commands + "\"\"\"])\n";
}

std::filesystem::path program(const test::CaseDirectory& directory, const std::string& text) {
  std::filesystem::path file = directory.write("mesher", text);
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  return file;
}

/// This process's children, as /proc lists them.
std::vector<std::filesystem::path> children() {
  const std::string own = std::to_string(getpid());
  std::vector<std::filesystem::path> found;
  std::ifstream list("/proc/" + own + "/task/" + own + "/children");
  for (std::string id; list >> id;) found.emplace_back("/proc/" + id);
  return found;
}

/// What a mesher that runs these commands is said to have answered.
MesherAnswer answer_of(const std::string& commands) {
  const test::CaseDirectory directory;
  const GeometryTask task{2, "/", "nothing.geo", FileKind::geometry, 0.};
  return Mesher(program(directory, one_task(commands))).answer(task, {1e9, 20.});
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

TEST(Mesher, AProgramThatEndsAtOnceIsSaidWithItsLastMessage) {
  const test::CaseDirectory directory;
  const GeometryTask task{2, "/", "nothing.geo", FileKind::geometry, 0.};
  Mesher mesher(program(directory, "#!/bin/sh\necho 'a library is missing' >&2\n"));
  try {
    (void)mesher.answer(task, {1e9, 20.});
    FAIL() << "it answered";
  } catch (const base::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("ended with exit code 0: a library is missing"),
              std::string::npos)
        << error.what();
  }
}

TEST(Mesher, AProgramThatDoesNotAnswerIsGivenUpWithItsTask) {
  const test::CaseDirectory directory;
  const GeometryTask task{2, "/", "nothing.geo", FileKind::geometry, 0.};
  Mesher mesher(program(directory, "#!/bin/sh\nexec sleep 100\n"));
  EXPECT_THROW((void)mesher.answer(task, {1e9, 0.2}), base::LimitReached);
}

/// The mesher's own program, killed, and signals that interrupt what waits for it.
TEST(Mesher, AProgramThatIsKilledIsStartedAgain) {
  const test::CaseDirectory directory;
  (void)directory.write("empty.geo", "Point(1) = {0, 0, 0};\n");
  const GeometryTask task{2, directory.path().string(), "empty.geo", FileKind::geometry, 0.};
  Mesher mesher(MESHER);
  const MesherAnswer first = mesher.answer(task, {1e9, 20.});
  const std::vector<std::filesystem::path> programs = children();
  ASSERT_FALSE(programs.empty());
  for (const std::filesystem::path& process : programs) {
    kill(static_cast<pid_t>(std::stol(process.filename().string())), SIGKILL);
    const MesherAnswer again = mesher.answer(task, {1e9, 20.});
    EXPECT_EQ(first.errors, again.errors);
  }
}

TEST(Mesher, SignalsThatInterruptTheWaitingChangeNothing) {
  const test::CaseDirectory directory;
  (void)directory.write("empty.geo", "Point(1) = {0, 0, 0};\n");
  const GeometryTask task{2, directory.path().string(), "empty.geo", FileKind::geometry, 0.};
  struct sigaction ignoring {};
  ignoring.sa_handler = [](int) {};
  struct sigaction before {};
  sigaction(SIGALRM, &ignoring, &before);
  const itimerval often{{0, 2000}, {0, 2000}};
  const itimerval never{};
  setitimer(ITIMER_REAL, &often, nullptr);
  Mesher mesher(MESHER);
  const MesherAnswer first = mesher.answer(task, {1e9, 20.});
  const MesherAnswer again = mesher.answer(task, {1e9, 20.});
  setitimer(ITIMER_REAL, &never, nullptr);
  sigaction(SIGALRM, &before, nullptr);
  EXPECT_FALSE(first.errors.empty());
  EXPECT_EQ(first.errors, again.errors);
}

TEST(Mesher, EachTaskHasAProcessOfItsOwnOfOneProgram) {
  Mesher mesher(MESHER);
  const test::CaseDirectory directory;
  (void)directory.write("empty.geo", "Point(1) = {0, 0, 0};\n");
  const GeometryTask task{2, directory.path().string(), "empty.geo", FileKind::geometry, 0.};
  const MesherAnswer first = mesher.answer(task, {1e9, 20.});
  const MesherAnswer again = mesher.answer(task, {1e9, 20.});
  EXPECT_EQ(first.errors, again.errors);
  EXPECT_FALSE(first.errors.empty());
}

}  // namespace
}  // namespace geneva::mesh
