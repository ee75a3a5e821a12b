#include "cad/step_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "base/errors.h"
#include "loads/pi.h"
#include "loads/wheel/outline_shapes.h"
#include "tests/support/private_directory.h"

namespace geneva::cad {
namespace {

using loads::Outline;
using loads::SolidPart;
using testing::Contains;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

/// A ring on whose top a smaller one stands.
SolidPart stepped_ring(const std::string& name, const loads::Placement& placement) {
  const Outline wide{
      "wide",
      {loads::circle({0., 0.}, 0.03, false, "rim"), loads::circle({0., 0.}, 0.01, true, "bore")}};
  const Outline narrow{
      "narrow",
      {loads::circle({0., 0.}, 0.02, false, "hub"), loads::circle({0., 0.}, 0.01, true, "bore")}};
  return {name, {{wide, 0., 0.005}, {narrow, 0.005, 0.02}}, placement};
}

constexpr double ring_volume = loads::pi * ((0.0009 - 0.0001) * 0.005 + (0.0004 - 0.0001) * 0.015);

class StepFile : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file() const { return directory_.path() / "parts.step"; }

 private:
  test::PrivateDirectory directory_;
};

TEST_F(StepFile, HasNamesAndVolumeOfAPartInEveryUnitAndOrder) {
  for (const FileUnit unit : {FileUnit::inch, FileUnit::millimetre, FileUnit::inch}) {
    write_step(file(), {stepped_ring("ring", {0., {0., 0.}})}, "", unit);
    const std::vector<StepSolid> solids = solids_of_step(file());
    ASSERT_EQ(solids.size(), 1U);
    EXPECT_EQ(solids.front().name, "ring");
    EXPECT_NEAR(solids.front().volume, ring_volume, 1e-12 * ring_volume);
    EXPECT_THAT(solids.front().faces,
                UnorderedElementsAre("bottom", "top", "shoulder", "rim", "hub", "bore"));
  }
}

TEST_F(StepFile, HasEveryPartOfAnAssembly) {
  write_step(file(),
             {stepped_ring("ring", {0., {0., 0.}}), stepped_ring("other", {1., {0.1, 0.}}),
              stepped_ring("ring", {2., {0., 0.1}})},
             "rings", FileUnit::millimetre);
  std::vector<std::string> names;
  for (const StepSolid& solid : solids_of_step(file())) {
    names.push_back(solid.name);
    EXPECT_NEAR(solid.volume, ring_volume, 1e-12 * ring_volume);
    EXPECT_THAT(solid.faces, Contains("shoulder"));
  }
  EXPECT_THAT(names, ElementsAre("ring", "other", "ring"));
}

TEST_F(StepFile, RefusesWhatIsNoStepFileOrHasNoShape) {
  EXPECT_THROW(solids_of_step(file()), base::InputError);
  std::ofstream(file()) << "no STEP file\n";
  EXPECT_THROW(solids_of_step(file()), base::InputError);
  std::ofstream(file())
      << "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
         "FILE_NAME('','',(''),(''),'','','');\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\n"
         "ENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n";
  EXPECT_THROW(solids_of_step(file()), base::InputError);
}

}  // namespace
}  // namespace geneva::cad
