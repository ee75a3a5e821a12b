#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <variant>

#include "tests/unit/model/case_directory.h"

namespace {

using namespace geneva::model::test;
using geneva::model::Case;
namespace fem = geneva::fem;
namespace fs = std::filesystem;

const char* const full_text = R"(
set Model = geometry
subsection Geometry
  set Length unit = mm
  set Plane = plane stress
  set Thickness = 20 mm
  set Bodies = upper roll, lower: block
  set Supports = bottom: fixed, left side: x, right: side : y
  set Loads = top, flank, core, axle, lid
  set Contact pairs = roll -> block top, rim->wall
  subsection Body upper roll
    set Young's modulus = 210 GPa
    set Poisson's ratio = 0.25
    set Density = 8000 kg/m^3
    set Body force = 0 N/m^3, -5 kN/m^3
    set Gravity = 1 m/s^2, -10 m/s^2
  end
  subsection Body lower: block
    set Young's modulus = 70 GPa
  end
  subsection Load top
    set Value = 3 MPa
  end
  subsection Load flank
    set Type = traction
    set Value = 10 MPa
    set Direction = 3, -4
  end
  subsection Load core
    set Type = force
    set Value = 2 kN
    set Direction = 0, -1
  end
  subsection Load axle
    set Type = force per thickness
    set Value = 35 kN/mm
    set Direction = -2, 0
  end
  subsection Load lid
    set Type = displacement
    set Value = -0.1 mm
    set Direction = 0, 1
  end
end
)";

/// A geometry case with lines in its subsection (the first is line 6) and its bodies' and loads'.
std::string geometry_text(const std::string& inside = "") {
  return "set Model = geometry\n"
         "subsection Geometry\n"
         "  set Thickness = 1 m\n"
         "  set Bodies = roll, block\n"
         "  set Contact pairs = rim -> wall\n" +
         inside + "end\n";
}

/// Message of the refusal of a case that has a geometry.geo; "accepted" if there is none.
std::string refusal_with_geometry(const std::string& text) {
  const CaseDirectory directory(text);
  directory.write("geometry.geo", "");
  return directory.refusal();
}

Case read_with_geometry(const std::string& text) {
  const CaseDirectory directory(text);
  directory.write("geometry.geo", "");
  return directory.read();
}

/// The problem of a case with Dimension = 2 (the default) or 3.
template <int dim = 2>
fem::Problem<dim> problem_of(const Case& given) {
  return std::get<fem::Problem<dim>>(given.geometry->problem);
}

void expect_same(const fem::Problem<2>& value, const fem::Problem<2>& expected) {
  EXPECT_EQ(value.plane, expected.plane);
  EXPECT_EQ(value.thickness, expected.thickness);
  ASSERT_EQ(value.bodies.size(), expected.bodies.size());
  for (std::size_t i = 0; i < value.bodies.size(); ++i) {
    EXPECT_EQ(value.bodies[i].name, expected.bodies[i].name);
    EXPECT_EQ(value.bodies[i].material.youngs_modulus, expected.bodies[i].material.youngs_modulus);
    EXPECT_EQ(value.bodies[i].material.poissons_ratio, expected.bodies[i].material.poissons_ratio);
    EXPECT_EQ(value.bodies[i].force.uniform, expected.bodies[i].force.uniform);
  }
  ASSERT_EQ(value.supports.size(), expected.supports.size());
  for (std::size_t i = 0; i < value.supports.size(); ++i) {
    EXPECT_EQ(value.supports[i].surface, expected.supports[i].surface);
    EXPECT_EQ(value.supports[i].displacement, expected.supports[i].displacement);
  }
  ASSERT_EQ(value.loads.size(), expected.loads.size());
  for (std::size_t i = 0; i < value.loads.size(); ++i) {
    EXPECT_EQ(value.loads[i].surface, expected.loads[i].surface);
    EXPECT_EQ(value.loads[i].pressure, expected.loads[i].pressure);
    EXPECT_EQ(value.loads[i].traction, expected.loads[i].traction);
  }
  ASSERT_EQ(value.ties.size(), expected.ties.size());
  for (std::size_t i = 0; i < value.ties.size(); ++i) {
    EXPECT_EQ(value.ties[i].surface, expected.ties[i].surface);
    EXPECT_EQ(value.ties[i].direction, expected.ties[i].direction);
    EXPECT_EQ(value.ties[i].force, expected.ties[i].force);
  }
  ASSERT_EQ(value.pairs.size(), expected.pairs.size());
  for (std::size_t i = 0; i < value.pairs.size(); ++i) {
    EXPECT_EQ(value.pairs[i].source, expected.pairs[i].source);
    EXPECT_EQ(value.pairs[i].target, expected.pairs[i].target);
  }
}

TEST(GeometryCase, BodiesKeepTheirNamesAndTakeTheirMaterials) {
  const fem::Problem<2> problem = problem_of(read_with_geometry(full_text));
  ASSERT_EQ(problem.bodies.size(), 2U);
  EXPECT_EQ(problem.bodies[0].name, "upper roll");
  EXPECT_EQ(problem.bodies[1].name, "lower: block");
  EXPECT_DOUBLE_EQ(problem.bodies[0].material.youngs_modulus, 210e9);
  EXPECT_DOUBLE_EQ(problem.bodies[0].material.poissons_ratio, 0.25);
  EXPECT_DOUBLE_EQ(problem.bodies[1].material.youngs_modulus, 70e9);
  EXPECT_DOUBLE_EQ(problem.bodies[1].material.poissons_ratio, 0.3);
}

TEST(GeometryCase, GravityIsAnAccelerationBesideTheBodyForce) {
  const fem::Problem<2> problem = problem_of(read_with_geometry(full_text));
  EXPECT_DOUBLE_EQ(problem.bodies[0].density, 8000.);
  EXPECT_EQ(problem.bodies[0].force.uniform, (fem::Components<2>{0., -5000.}));
  EXPECT_EQ(problem.bodies[0].force.acceleration, (fem::Components<2>{1., -10.}));
  EXPECT_EQ(problem.bodies[0].force.rotation.inertia, 0.);
  EXPECT_EQ(problem.bodies[1].force.uniform[0], 0.);
  EXPECT_EQ(problem.bodies[1].force.uniform[1], 0.);
}

TEST(GeometryCase, SupportsHoldTheComponentsThatTheyName) {
  const auto supports = problem_of(read_with_geometry(full_text)).supports;
  ASSERT_EQ(supports.size(), 4U);
  EXPECT_EQ(supports[0].surface, "bottom");
  EXPECT_EQ(supports[0].displacement[0], 0.);
  EXPECT_EQ(supports[0].displacement[1], 0.);
  EXPECT_EQ(supports[1].surface, "left side");
  EXPECT_EQ(supports[1].displacement[0], 0.);
  EXPECT_FALSE(supports[1].displacement[1]);
  EXPECT_EQ(supports[2].surface, "right: side");
  EXPECT_FALSE(supports[2].displacement[0]);
  EXPECT_EQ(supports[2].displacement[1], 0.);
}

TEST(GeometryCase, ADisplacementBecomesASupportInBothComponents) {
  const auto supports = problem_of(read_with_geometry(full_text)).supports;
  ASSERT_EQ(supports.size(), 4U);
  EXPECT_EQ(supports[3].surface, "lid");
  EXPECT_EQ(supports[3].displacement[0], 0.);
  EXPECT_DOUBLE_EQ(*supports[3].displacement[1], -1e-4);
}

TEST(GeometryCase, PressureAndTractionBecomeSurfaceLoads) {
  const auto loads = problem_of(read_with_geometry(full_text)).loads;
  ASSERT_EQ(loads.size(), 2U);
  EXPECT_EQ(loads[0].surface, "top");
  EXPECT_DOUBLE_EQ(loads[0].pressure, 3e6);
  EXPECT_EQ(loads[0].traction[0], 0.);
  EXPECT_EQ(loads[0].traction[1], 0.);
  EXPECT_EQ(loads[1].surface, "flank");
  EXPECT_EQ(loads[1].pressure, 0.);
  EXPECT_DOUBLE_EQ(loads[1].traction[0], 6e6);
  EXPECT_DOUBLE_EQ(loads[1].traction[1], -8e6);
}

TEST(GeometryCase, AForceBecomesARigidTieAndALineLoadIsTimesTheThickness) {
  const auto ties = problem_of(read_with_geometry(full_text)).ties;
  ASSERT_EQ(ties.size(), 2U);
  EXPECT_EQ(ties[0].surface, "core");
  EXPECT_EQ(ties[0].direction[0], 0.);
  EXPECT_EQ(ties[0].direction[1], -1.);
  EXPECT_DOUBLE_EQ(ties[0].force, 2000.);
  EXPECT_EQ(ties[1].surface, "axle");
  EXPECT_EQ(ties[1].direction[0], -1.);
  EXPECT_EQ(ties[1].direction[1], 0.);
  EXPECT_DOUBLE_EQ(ties[1].force, 35e6 * 0.02);
}

TEST(GeometryCase, ContactPairsKeepTheirSides) {
  const auto pairs = problem_of(read_with_geometry(full_text)).pairs;
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[0].source, "roll");
  EXPECT_EQ(pairs[0].target, "block top");
  EXPECT_EQ(pairs[1].source, "rim");
  EXPECT_EQ(pairs[1].target, "wall");
}

TEST(GeometryCase, PlaneKindsAndThicknessArrive) {
  const fem::Problem<2> stress = problem_of(read_with_geometry(full_text));
  EXPECT_EQ(stress.plane, fem::PlaneKind::plane_stress);
  EXPECT_DOUBLE_EQ(stress.thickness, 0.02);
  EXPECT_EQ(problem_of(read_with_geometry(geometry_text())).plane, fem::PlaneKind::plane_strain);
  EXPECT_EQ(problem_of(read_with_geometry(
                           "set Model = geometry\nsubsection Geometry\nset Plane = "
                           "axisymmetric\nset Bodies = a\nset Contact pairs = b -> c\nend\n"))
                .plane,
            fem::PlaneKind::axisymmetric);
}

TEST(GeometryCase, LengthUnitsMayHaveANumber) {
  const auto unit = [](const std::string& text) {
    return read_with_geometry(geometry_text("set Length unit = " + text + "\n"))
        .geometry->length_unit;
  };
  EXPECT_EQ(read_with_geometry(geometry_text()).geometry->length_unit, 1.);
  EXPECT_DOUBLE_EQ(unit("mm"), 1e-3);
  EXPECT_DOUBLE_EQ(unit("1 mm"), 1e-3);
  EXPECT_DOUBLE_EQ(unit("in"), 0.0254);
  EXPECT_DOUBLE_EQ(unit("0.1 mm"), 1e-4);
  EXPECT_DOUBLE_EQ(unit("µm"), 1e-6);
}

TEST(GeometryCase, AWrongLengthUnitIsRefused) {
  for (const std::string unit : {"mmm", "s", "5", "0 mm", "-1 mm", "2 3 mm", ""})
    EXPECT_EQ(refusal_with_geometry(geometry_text("set Length unit = " + unit + "\n")),
              "DIR/case.prm, line 6: 'Length unit' = '" + unit +
                  "': a unit of length is wanted, for example 'mm', 'in' or '0.1 mm'");
}

TEST(GeometryCase, TheCompletedFileGivesTheSameCaseAndCompletesToItself) {
  for (const std::string& text : {std::string(full_text), geometry_text()}) {
    const Case given = read_with_geometry(text);
    const Case again = read_with_geometry(given.completed);
    EXPECT_FALSE(again.mechanism);
    EXPECT_EQ(again.geometry->file.filename(), given.geometry->file.filename());
    EXPECT_EQ(again.geometry->length_unit, given.geometry->length_unit);
    expect_same(problem_of(again), problem_of(given));
    EXPECT_EQ(again.completed, given.completed);
  }
}

TEST(GeometryCase, TheGeometryFileIsFoundInTheDirectory) {
  const CaseDirectory geo(geometry_text());
  geo.write("geometry.geo", "");
  EXPECT_EQ(geo.read().geometry->file, geo.path() / "geometry.geo");
  const CaseDirectory msh(geometry_text());
  msh.write("geometry.msh", "");
  EXPECT_EQ(msh.read().geometry->file, msh.path() / "geometry.msh");
}

TEST(GeometryCase, NoGeometryFileOrTwoAreRefused) {
  EXPECT_EQ(refusal(geometry_text()),
            "DIR/case.prm: the case directory has neither 'geometry.geo' nor 'geometry.msh'; 'set "
            "File = ...' in the subsection 'Geometry' names the file");
  const CaseDirectory both(geometry_text());
  both.write("geometry.geo", "");
  both.write("geometry.msh", "");
  EXPECT_EQ(both.refusal(),
            "DIR/case.prm: the case directory has both 'geometry.geo' and 'geometry.msh'; 'set "
            "File = ...' in the subsection 'Geometry' names the file");
}

TEST(GeometryCase, AFileOfTheDirectoryMayBeNamed) {
  const CaseDirectory directory(geometry_text("set File = parts/roll.geo\n"));
  directory.write("geometry.geo", "");
  fs::create_directory(directory.path() / "parts");
  directory.write("parts/roll.geo", "");
  EXPECT_EQ(directory.read().geometry->file, directory.path() / "parts/roll.geo");
}

TEST(GeometryCase, AFileOutsideOfTheDirectoryIsRefused) {
  const CaseDirectory other("");
  other.write("roll.geo", "");
  const std::string reason = "': a file in the case directory is wanted, not one outside of it";
  const auto check = [&](const std::string& name) {
    const CaseDirectory directory(geometry_text("set File = " + name + "\n"));
    fs::create_symlink(other.path() / "roll.geo", directory.path() / "link.geo");
    fs::create_directory_symlink(other.path(), directory.path() / "away");
    EXPECT_NE(directory.refusal().find(reason), std::string::npos) << directory.refusal();
  };
  check((other.path() / "roll.geo").string());
  check("../" + other.path().filename().string() + "/roll.geo");
  check("link.geo");
  check("away/roll.geo");
  check("../missing.geo");
}

TEST(GeometryCase, AFileThatIsMissingOrOfAnotherKindIsRefused) {
  EXPECT_EQ(refusal(geometry_text("set File = roll.geo\n")),
            "DIR/case.prm, line 6: 'File' = 'roll.geo': there is no such file in the case "
            "directory");
  for (const std::string name : {"case.prm", "roll", "", "roll.geo.pro"})
    EXPECT_EQ(
        refusal(geometry_text("set File = " + name + "\n")),
        "DIR/case.prm, line 6: 'File' = '" + name +
            "': the name of a .geo, .msh, .step or .stp file in the case directory is wanted");
}

TEST(GeometryCase, ThicknessIsWantedJustInPlaneModels) {
  EXPECT_EQ(refusal_with_geometry("set Model = geometry\nsubsection Geometry\nset Bodies = a\nset "
                                  "Contact pairs = b -> c\nend\n"),
            "DIR/case.prm: 'Thickness' is missing in the subsection 'Geometry': a plane model "
            "needs it, for example '4.53 in' or '115 mm'");
  EXPECT_EQ(refusal_with_geometry(geometry_text("set Plane = axisymmetric\n")),
            "DIR/case.prm, line 3: 'Thickness' = '1 m': an axisymmetric model has no thickness: "
            "delete it");
  EXPECT_EQ(refusal_with_geometry("set Model = geometry\nsubsection Geometry\nset Thickness = -1 "
                                  "mm\nend\n"),
            "DIR/case.prm, line 3: 'Thickness' = '-1 mm': the value must be greater than 0");
}

TEST(GeometryCase, MissingBodiesAreRefused) {
  EXPECT_EQ(refusal_with_geometry("set Model = geometry\n"),
            "DIR/case.prm: 'Bodies' is missing in the subsection 'Geometry': it takes names "
            "separated by commas");
}

TEST(GeometryCase, EmptyAndDoubleNamesAreRefused) {
  const auto reason = [](const std::string& line) {
    return refusal_with_geometry("set Model = geometry\nsubsection Geometry\nset " + line +
                                 "\nend\n");
  };
  EXPECT_EQ(reason("Bodies = a, b, a"),
            "DIR/case.prm, line 3: 'Bodies' = 'a, b, a': the name 'a' stands there twice");
  EXPECT_EQ(reason("Loads = a,, b"),
            "DIR/case.prm, line 3: 'Loads' = 'a,, b': a name between commas is empty");
  std::string many = "Bodies = a0";
  for (int i = 1; i <= 1000; ++i) many += ",a" + std::to_string(i);
  EXPECT_NE(reason(many).find("at most 1000 names are allowed"), std::string::npos);
}

TEST(GeometryCase, SubsectionsOfUnknownBodiesAndLoadsAreRefusedWithTheKnownOnes) {
  EXPECT_EQ(refusal_with_geometry(geometry_text("subsection Body rol\nend\n")),
            "DIR/case.prm, line 6: there is no subsection 'Body rol' in 'Geometry'; did you mean "
            "'Body roll'?");
  EXPECT_EQ(refusal_with_geometry(geometry_text("set Loads = top\nsubsection Load rim\nend\n")),
            "DIR/case.prm, line 7: there is no subsection 'Load rim' in 'Geometry'; there are "
            "'Body roll', 'Body block', 'Load top'");
  EXPECT_EQ(refusal_with_geometry(geometry_text("subsection Material of the wheel\nend\n")),
            "DIR/case.prm, line 6: there is no subsection 'Material of the wheel' in 'Geometry'; "
            "there are 'Body roll', 'Body block'");
  EXPECT_EQ(refusal_with_geometry(geometry_text() + "subsection Body roll\nend\n"),
            "DIR/case.prm, line 7: the subsection 'Body roll' belongs into the subsection "
            "'Geometry'");
}

TEST(GeometryCase, MisspeltSupportsAreRefused) {
  const auto reason = [](const std::string& value) {
    return refusal_with_geometry(geometry_text("set Supports = " + value + "\n"));
  };
  for (const std::string part : {"bottom", "bottom: z", ": fixed", "bottom:", ""})
    EXPECT_EQ(reason("side: x, " + part),
              "DIR/case.prm, line 6: 'Supports' = 'side: x," + (part.empty() ? "" : " " + part) +
                  "': '" + part + "': 'surface: fixed', 'surface: x' or 'surface: y' is wanted");
  EXPECT_EQ(reason("a: x, a: y"),
            "DIR/case.prm, line 6: 'Supports' = 'a: x, a: y': the surface 'a' stands there twice; "
            "'fixed' holds it in all directions, 'x y' in two");
}

TEST(GeometryCase, MisspeltContactPairsAreRefused) {
  const auto reason = [](const std::string& value) {
    return refusal_with_geometry(
        "set Model = geometry\nsubsection Geometry\nset Thickness = 1 m\nset Bodies = a\nset "
        "Contact pairs = " +
        value + "\nend\n");
  };
  const std::string start = "DIR/case.prm, line 5: 'Contact pairs' = '";
  for (const std::string pair : {"a", "a - b", "-> b", "a ->", "a -> b -> c", "a <- b"})
    EXPECT_EQ(reason(pair), start + pair + "': '" + pair + "': 'surface -> surface' is wanted");
  EXPECT_EQ(reason("a -> a"), start + "a -> a': the surface 'a' cannot touch itself");
  EXPECT_EQ(reason("a -> b, a->b"), start + "a -> b, a->b': the pair 'a->b' stands there twice");
}

std::string load_refusal(const std::string& lines, const std::string& inside = "") {
  return refusal_with_geometry(
      geometry_text("set Loads = top\nsubsection Load top\n" + lines + "end\n" + inside));
}

TEST(GeometryCase, LoadsWithTheUnitOfAnotherTypeAreRefused) {
  const std::string start = "DIR/case.prm, line 9: 'Load top/Value' = ";
  EXPECT_EQ(load_refusal("set Type = pressure\nset Value = 5 N\n"),
            start +
                "'5 N': for Type = pressure a stress with its unit is wanted, for example "
                "'30e6 psi' or '207 GPa'");
  EXPECT_EQ(load_refusal("set Type = force\nset Value = 5 N/mm\nset Direction = 0, 1\n"),
            start +
                "'5 N/mm': for Type = force a force with its unit is wanted, for example '100 "
                "lbf' or '450 N'");
  EXPECT_EQ(load_refusal("set Type = force per thickness\nset Value = 5 N\nset Direction = 0, 1\n"),
            start +
                "'5 N': for Type = force per thickness a force per length with its unit is wanted, "
                "for example '35 kN/mm' or '200 lbf/in'");
  EXPECT_EQ(load_refusal("set Type = displacement\nset Value = 5\nset Direction = 0, 1\n"),
            start +
                "'5': for Type = displacement a length with its unit is wanted, for example "
                "'4.53 in' or '115 mm'");
  EXPECT_EQ(load_refusal("set Type = weight\n"),
            "DIR/case.prm, line 8: 'Load top/Type' = 'weight': one of 'pressure', 'traction', "
            "'force', 'force per thickness', 'displacement' is wanted");
  EXPECT_EQ(load_refusal(""),
            "DIR/case.prm: 'Value' is missing in the subsection 'Load top': it takes a value with "
            "the unit that the type asks for");
}

TEST(GeometryCase, WrongDirectionsAreRefused) {
  const auto reason = [](const std::string& direction) {
    return load_refusal("set Type = force\nset Value = 5 N\nset Direction = " + direction + "\n");
  };
  const std::string start = "DIR/case.prm, line 10: 'Load top/Direction' = ";
  EXPECT_EQ(reason("0, 0"), start + "'0, 0': a direction that is not zero is wanted");
  EXPECT_EQ(reason("1e300, 1e-400"),
            start +
                "'1e-400': the number is too large or too small; a plain number or a "
                "percentage is wanted, for example '0.3' or '30 %'");
  for (const std::string direction : {"1", "1, 2, 3, 4", "x"})
    EXPECT_EQ(reason(direction),
              start + "'" + direction +
                  "': 2 or 3 values separated by a comma are wanted, each a plain number or a "
                  "percentage, for example '0.3' or '30 %'");
  EXPECT_EQ(reason("1 mm, 2 mm"),
            start +
                "'1 mm': 'mm' does not belong to a plain number; a plain number or a "
                "percentage is wanted, for example '0.3' or '30 %'");
  EXPECT_EQ(reason("0, 0, 1"), start + "'0, 0, 1': two components are wanted with Dimension = 2");
  EXPECT_EQ(load_refusal("set Type = force\nset Value = 5 N\n"),
            "DIR/case.prm: 'Direction' is missing in the subsection 'Load top': Type = force needs "
            "it, for example '0, -1'");
  EXPECT_EQ(load_refusal("set Value = 5 Pa\nset Direction = 0, 1\n"),
            "DIR/case.prm, line 9: 'Load top/Direction' = '0, 1': a pressure acts along the "
            "normal; Type = traction has a direction");
}

TEST(GeometryCase, ASurfaceThatALoadHoldsCannotBeSupportedToo) {
  for (const std::string type : {"force\nset Value = 5 N", "displacement\nset Value = 5 mm"})
    EXPECT_NE(
        load_refusal("set Type = " + type + "\nset Direction = 0, 1\n", "set Supports = top: x\n")
            .find("the surface 'top' cannot be in 'Supports' too: this load holds it "
                  "already"),
        std::string::npos);
  EXPECT_EQ(load_refusal("set Value = 5 Pa\n", "set Supports = top: x\n"), "accepted");
}

TEST(GeometryCase, AForcePerThicknessIsRefusedInAnAxisymmetricModel) {
  EXPECT_EQ(refusal_with_geometry(
                "set Model = geometry\nsubsection Geometry\nset Plane = axisymmetric\nset Bodies = "
                "a\nset Contact pairs = b -> c\nset Loads = top\nsubsection Load top\nset Type = "
                "force per thickness\nset Value = 5 N/mm\nset Direction = 0, 1\nend\nend\n"),
            "DIR/case.prm, line 8: 'Load top/Type' = 'force per thickness': an axisymmetric model "
            "has no thickness; Type = force is wanted");
}

TEST(GeometryCase, WrongBodyForcesAreRefused) {
  const auto reason = [](const std::string& line) {
    return refusal_with_geometry(geometry_text("subsection Body roll\nset " + line + "\nend\n"));
  };
  const std::string start = "DIR/case.prm, line 7: 'Body roll/";
  EXPECT_EQ(reason("Body force = 5 N/m^3"),
            start +
                "Body force' = '5 N/m^3': 2 or 3 values separated by a comma are wanted, each a "
                "force per volume with its unit, for example '77e3 N/m^3' or '0.28 lbf/in^3'");
  EXPECT_EQ(reason("Gravity = 0 m/s^2, 9.81"),
            start +
                "Gravity' = '9.81': an acceleration with its unit is wanted, for example '9.81 "
                "m/s^2' or '386 in/s^2'");
  EXPECT_EQ(reason("Poisson's ratio = 0.5"),
            start +
                "Poisson's ratio' = '0.5': the value must be greater than -1 and at most "
                "0.4999");
}

const char* const text_in_space = R"(
set Model = geometry
set Dimension = 3
subsection Geometry
  set Bodies = ball, block
  set Supports = bottom: fixed, side: x, lid: z, rail: x z
  set Loads = core, flank, top
  set Contact pairs = round -> top face
  subsection Body ball
    set Density = 8000 kg/m^3
    set Body force = 0 N/m^3, 1 kN/m^3, -5 kN/m^3
    set Gravity = 1 m/s^2, -10 m/s^2, 2 m/s^2
  end
  subsection Load core
    set Type = force
    set Value = 2 kN
    set Direction = 0, -3, 4
  end
  subsection Load flank
    set Type = traction
    set Value = 9 MPa
    set Direction = 1, 2, -2
  end
  subsection Load top
    set Type = displacement
    set Value = 0.1 mm
    set Direction = 0, 0, 1
  end
end
)";

TEST(GeometryCaseInSpace, BodiesSupportsAndLoadsHaveThreeComponents) {
  const fem::Problem<3> problem = problem_of<3>(read_with_geometry(text_in_space));
  EXPECT_EQ(problem.bodies[0].force.uniform, (fem::Components<3>{0., 1000., -5000.}));
  EXPECT_EQ(problem.bodies[0].force.acceleration, (fem::Components<3>{1., -10., 2.}));
  EXPECT_EQ(problem.bodies[1].force.uniform, (fem::Components<3>{0., 0., 0.}));
  using Held = std::array<std::optional<double>, 3>;
  ASSERT_EQ(problem.supports.size(), 5U);
  EXPECT_EQ(problem.supports[0].displacement, (Held{0., 0., 0.}));
  EXPECT_EQ(problem.supports[1].displacement, (Held{0., std::nullopt, std::nullopt}));
  EXPECT_EQ(problem.supports[2].displacement, (Held{std::nullopt, std::nullopt, 0.}));
  EXPECT_EQ(problem.supports[3].displacement, (Held{0., std::nullopt, 0.}));
  EXPECT_EQ(problem.supports[4].displacement, (Held{0., 0., 1e-4}));
  ASSERT_EQ(problem.ties.size(), 1U);
  EXPECT_EQ(problem.ties[0].direction, (fem::Components<3>{0., -0.6, 0.8}));
  EXPECT_DOUBLE_EQ(problem.ties[0].force, 2000.);
  ASSERT_EQ(problem.loads.size(), 1U);
  EXPECT_DOUBLE_EQ(problem.loads[0].traction[2], -6e6);
}

TEST(GeometryCaseInSpace, TheCompletedFileGivesTheSameCase) {
  const Case given = read_with_geometry(text_in_space);
  EXPECT_EQ(read_with_geometry(given.completed).completed, given.completed);
}

TEST(GeometryCaseInSpace, WhatIsForAPlaneIsRefused) {
  const auto reason = [](const std::string& line, const std::string& load) {
    return refusal_with_geometry(
        "set Model = geometry\nset Dimension = 3\nsubsection Geometry\nset Bodies = roll, block\n"
        "set Contact pairs = rim -> wall\nset Loads = top\n" +
        line + "subsection Load top\nset Value = 5 N\n" + load + "end\nend\n");
  };
  const std::string force = "set Type = force\nset Direction = 0, 0, 1\n";
  EXPECT_EQ(reason("", force), "accepted");
  EXPECT_EQ(reason("set Thickness = 1 mm\n", force),
            "DIR/case.prm, line 7: 'Thickness' = '1 mm': this has an effect with Dimension = 2 "
            "only: delete it");
  EXPECT_EQ(reason("set Plane = plane stress\n", force),
            "DIR/case.prm, line 7: 'Plane' = 'plane stress': this has an effect with Dimension = 2 "
            "only: delete it");
  EXPECT_EQ(reason("", "set Type = force\nset Direction = 0, 1\n"),
            "DIR/case.prm, line 10: 'Load top/Direction' = '0, 1': three components are wanted "
            "with Dimension = 3");
  EXPECT_EQ(reason("set Supports = a: y, b: w\n", force),
            "DIR/case.prm, line 7: 'Supports' = 'a: y, b: w': 'b: w': 'surface: fixed', "
            "'surface: x', 'surface: y' or 'surface: z' is wanted");
}

}  // namespace
