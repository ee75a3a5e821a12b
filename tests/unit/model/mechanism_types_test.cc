#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <set>
#include <string>

#include "loads/pi.h"
#include "model/input/motion_table.h"
#include "model/mechanism_motion.h"
#include "tests/support/private_directory.h"
#include "tests/unit/model/case_directory.h"

namespace {

using namespace geneva::model::test;
using geneva::model::driven_mechanism;
using geneva::model::MechanismCase;
using geneva::model::sizes_of;

using geneva::loads::degree;
using geneva::loads::pi;
const std::string load = "set Load inertia = 1 kg.m^2\nset Wheel inertia = 1 kg.m^2\n";

MechanismCase read(const std::string& text) {
  return *CaseDirectory("subsection Mechanism\n" + load + text + "end\n").read().mechanism;
}

std::string refused(const std::string& text) {
  return refusal("subsection Mechanism\n" + load + text + "end\n");
}

void expect_in(const std::string& message, const std::string& part) {
  EXPECT_NE(message.find(part), std::string::npos) << "no '" << part << "' in: " << message;
}

TEST(MechanismTypes, EachHasItsOwnSize) {
  const std::string start = "set Stations = 6\nset Driver speed = 60 rpm\n";
  const std::string local = "set Contact model = local\n";
  // Twice the distance of pin and wheel axis at entry: c cos(30 deg), c cos(30 deg), R sin(30 deg)
  EXPECT_NEAR(sizes_of(read(start + "set Centre distance = 1 m\n")).wheel_diameter, std::sqrt(3.),
              1e-12);
  EXPECT_NEAR(
      sizes_of(read(start + "set Type = internal\nset Crank radius = 0.5 m\n")).wheel_diameter,
      std::sqrt(3.), 1e-12);
  const auto spherical = read(start + local + "set Type = spherical\nset Sphere radius = 1 m\n");
  EXPECT_NEAR(sizes_of(spherical).wheel_diameter, 2., 1e-12);
  EXPECT_LT(std::abs(spherical.type->driver_axis()->z), 1e-15) << "shafts at a right angle";
  const auto chain = read(start + local + "set Type = long dwell\nset Crank radius = 0.5 m\n" +
                          "set Sprocket spacing = 0.7 m\n");
  EXPECT_NEAR(driven_mechanism(chain).mechanism().period, 2. * pi + 2.8, 1e-12);
  EXPECT_NEAR(sizes_of(chain).pin_diameter, 0.14 * std::sqrt(3.), 1e-12);
}

TEST(MechanismTypes, RefuseTheSizesOfOthers) {
  const std::string start = "set Stations = 6\nset Driver speed = 60 rpm\n";
  expect_in(refused(start + "set Type = spherical\nset Crank radius = 1 m\n"), "'Crank radius'");
  expect_in(refused(start + "set Type = spherical\n"), "'Sphere radius' is missing");
  expect_in(refused(start + "set Type = long dwell\nset Wheel diameter = 1 m\n"),
            "'Wheel diameter'");
  expect_in(refused(start + "set Wheel diameter = 1 m\nset Sphere radius = 1 m\n"),
            "'Sphere radius' = '1 m': this has no effect with Type = external");
  expect_in(refused(start + "set Type = spherical\nset Sphere radius = 1 m\n"),
            "needs 'Contact model = local'");
  expect_in(refused(start + "set Type = spherical\nset Sphere radius = 1 m\nset Shaft angle = 190 "
                            "deg\nset Contact model = local\n"),
            "shaft angle is 190 deg");
}

TEST(MechanismTypes, RefuseWhatOnlyOthersHave) {
  const std::string start =
      "set Stations = 6\nset Wheel diameter = 1 m\nset Driver speed = 60 rpm\n";
  expect_in(refused(start + "set Shaft angle = 80 deg\n"), "Type = spherical only");
  expect_in(refused(start + "set Sprocket line = across line of centres\n"),
            "Type = long dwell only");
  expect_in(refused(start + "subsection Linkage\nset Coupler point angle = 10 deg\nend\n"),
            "Type = four-bar only");
  expect_in(refused("set Stations = 6\nset Type = four-bar\nset Driver speed = 60 rpm\n"),
            "'Crank' is missing");
}

TEST(MechanismTypes, HaveUniqueNamesAndParameters) {
  std::set<std::string> names;
  for (const geneva::model::MechanismKind& kind : geneva::model::mechanism_kinds()) {
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    for (const geneva::model::Parameter& parameter : kind.parameters) {
      EXPECT_EQ(parameter.section, kind.section);
      EXPECT_TRUE(names.insert(parameter.name).second) << parameter.name;
    }
  }
}

TEST(Pins, AreCountedOrPlaced) {
  const std::string start =
      "set Stations = 6\nset Wheel diameter = 1 m\nset Driver speed = 1 rpm\n";
  EXPECT_EQ(driven_mechanism(read(start)).engagements().size(), 1U);
  EXPECT_EQ(driven_mechanism(read(start + "set Pins = 3\n")).engagements().size(), 3U);
  const auto unequal = driven_mechanism(read(start + "set Pin angles = 0 deg, 150 deg\n"));
  EXPECT_NEAR(unequal.engagements().at(1).engagement.middle, 150. * degree, 1e-12);
  expect_in(refused(start + "set Pins = 4\n"), "3 equally spaced pins at most");
  expect_in(refused(start + "set Pin angles = 0 deg, 100\n"), "'Pin angles'");
  expect_in(refused(start + "set Pin angles = 0 deg, 100 deg\n"), "together");
  expect_in(refused(start + "set Pin angles = 10 deg\n"), "the first is 0 deg");
  expect_in(refused(start + "set Pins = 2\nset Pin angles = 0 deg, 180 deg\n"), "'Pins'");
}

TEST(DriverMotion, IsALawATableOrConstant) {
  const std::string start = "set Stations = 6\nset Wheel diameter = 1 m\n";
  const auto cross = driven_mechanism(
      read(start + "set Driver motion = cycloidal on the cross\nset Motion time = 100 ms\n"));
  EXPECT_NEAR(cross.drive().reference_speed, 120. * degree / 0.1, 1e-10);
  EXPECT_EQ(cross.unbounded().size(), 2U);
  expect_in(refused(start + "set Driver motion = harmonic on the carrier\n"),
            "'Motion time' is missing");
  expect_in(refused(start + "set Driver motion = harmonic on the carrier\nset Motion time = 1 s\n"
                            "set Driver speed = 1 rpm\n"),
            "'Driver speed'");
  expect_in(refused(start + "set Driver speed = 1 rpm\nset Motion time = 1 s\n"), "'Motion time'");
  expect_in(refused("set Stations = 6\nset Type = long dwell\nset Crank radius = 1 m\n"
                    "set Contact model = local\nset Driver motion = harmonic on the cross\n"
                    "set Motion time = 1 s\n"),
            "Type = external or internal");
  expect_in(refused(start + "set Driver motion = table\n"), "'Motion table' is missing");
  expect_in(refused(start + "set Driver motion = table\nset Motion table = ../motion.csv\n"),
            "not one outside of it");
  expect_in(refused(start + "set Driver motion = table\nset Motion table = motion.csv\n"),
            "there is no such file");
}

class TableFile {
 public:
  explicit TableFile(const std::string& text) : path_(directory_.write("motion.csv", text)) {}

  [[nodiscard]] std::string refusal() const {
    try {
      geneva::model::read_motion_table(path_);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "was not refused";
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  geneva::test::PrivateDirectory directory_;
  std::filesystem::path path_;
};

TEST(MotionTable, IsReadInItsUnits) {
  const TableFile file("# a servo\ntime [ms], angle [deg]\n\n0, -180\n 10 ,-90\n20,1e1\n");
  const auto table = geneva::model::read_motion_table(file.path());
  ASSERT_EQ(table.times.size(), 3U);
  EXPECT_NEAR(table.times[1], 0.01, 1e-17);
  EXPECT_NEAR(table.angles[0], -pi, 1e-15);
  EXPECT_NEAR(table.angles[2], pi / 18., 1e-15);
}

TEST(MotionTable, RefusesWhatIsNoTable) {
  expect_in(TableFile("0, 1\n").refusal(), "'time [s], angle [deg]' is wanted");
  expect_in(TableFile("time [m], angle [deg]\n").refusal(), "line 1");
  expect_in(TableFile("time [s], angle [deg]\n1, x\n").refusal(),
            "line 2: '1, x' is not two numbers");
  expect_in(TableFile("time [s], angle [deg]\n1\n").refusal(), "not two columns");
  EXPECT_TRUE(geneva::model::read_motion_table(TableFile("").path()).times.empty());
}

}  // namespace
