#include "model/input/case_file.h"
#include "base/errors.h"
#include "tests/fuzz/reader.h"
#include "tests/support/private_directory.h"

// The case file, from its text to what is to be done.

namespace {

/// A case directory with the files that the shipped cases name.
class Room {
 public:
  Room() {
    for (const char* const name : {"geometry.geo", "geometry.msh", "points.csv", "motion.csv"})
      (void)directory_.write(name, "x [mm], y [mm]\n1, 2\n2, 3\n3, 4\n4, 4\n5, 3\n");
  }

  void read(const std::string& text) const {
    (void)directory_.write("case.prm", text);
    (void)geneva::model::read_case(directory_.path());
  }

 private:
  geneva::test::PrivateDirectory directory_;
};

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* const data, const std::size_t size) {
  static const Room room;
  try {
    room.read(geneva::fuzz::text_of(data, size));
  } catch (const geneva::base::InputError&) {  // a refusal, in words
  }
  return 0;
}
