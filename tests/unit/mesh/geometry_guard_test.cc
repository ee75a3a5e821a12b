#include "mesh/geometry_guard.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "case_directory.h"
#include "tests/support/refusal.h"

namespace geneva::mesh {
namespace {

using loads::test::expect_refused;
using test::CaseDirectory;

std::string guarded(const std::string& text) {
  const CaseDirectory directory;
  return guard_geometry(directory.write("geometry.geo", text)).text;
}

struct Sample {
  std::string name;
  std::string text;
  std::string told;  ///< what the message has to hold; empty: accepted
};

std::ostream& operator<<(std::ostream& stream, const Sample& sample) {
  return stream << sample.name;
}

std::string name_of(const testing::TestParamInfo<Sample>& info) { return info.param.name; }

class Accepted : public testing::TestWithParam<Sample> {};
TEST_P(Accepted, IsGivenToGmsh) { EXPECT_NO_THROW((void)guarded(GetParam().text)); }

INSTANTIATE_TEST_SUITE_P(
    Geometry, Accepted,
    testing::Values(
        Sample{"points_and_curves",
               "lc = 1e-3; Point(1) = {0, -.5, 0, lc}; Point(newp) = {1., 2e3, 0};\n"
               "Line(1) = {1, 2}; Circle(2) = {1, 2, 3}; Ellipse(3) = {1, 2, 3, 4};\n"
               "Spline(4) = {1:3}; BSpline(5) = {1, 2, 3}; Bezier(6) = {1, 2, 3};",
               ""},
        Sample{"surfaces",
               "Curve Loop(1) = {1, -2}; Line Loop(2) = {3}; Plane Surface(1) = {1, 2};\n"
               "Physical Surface(\"wheel\", 3) = {1}; Physical Curve(\"driving wall\") = {1};",
               ""},
        Sample{"meshing",
               "Transfinite Curve {1, -2} = 10 Using Progression 1.1;\n"
               "Transfinite Surface {1} = {1, 2, 3, 4} Left; Recombine Surface {1};\n"
               "Characteristic Length {1} = 0.1; MeshSize {:} = 1; Mesh.RecombineAll = 1;\n"
               "Mesh.Algorithm = 6; Mesh.Color.Lines = Red; Geometry.Tolerance = 1e-9; Mesh 2;",
               ""},
        Sample{"fields",
               "Field[1] = Distance; Field[1].CurvesList = {1}; Field[2] = Threshold;\n"
               "Field[2].InField = 1; Field[3] = MathEval; Field[3].F = \"0.1 + x\";\n"
               "Field[4] = Min; Field[4].FieldsList = {2, 3}; Background Field = 4;",
               ""},
        Sample{"loops_and_conditions",
               "n = 3; For i In {0:n-1} If (i == 1 && n > 2) a(i) = i^2; ElseIf (i >= 2) b = 1;\n"
               "Else c~{i} = -i; EndIf EndFor\nFor (1:3) x = 1; EndFor",
               ""},
        Sample{"macros",
               "Macro corner\n Point(p) = {0, 0, 0}; p += 1;\nReturn\np = 1; Call corner;", ""},
        Sample{"transformations",
               "Rotate {{0, 0, 1}, {0, 0, 0}, Pi/2} {Duplicata{Surface{1};}}\n"
               "Translate {1, 0, 0} {Point{1};} b() = Boundary{Surface{1};};\n"
               "out[] = Extrude {0, 1, 0} {Curve{1}; Layers{5}; Recombine;};",
               ""},
        Sample{
            "boolean_operations",
            "SetFactory(\"OpenCASCADE\"); Rectangle(1) = {0, 0, 0, 1, 1}; Disk(2) = {0, 0, 0, 1};\n"
            "BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };",
            ""},
        Sample{
            "texts",
            "name = \"pin's core (\xC3\xA9tage 1)\"; i = 3; Printf(\"i = %g, %5.2f %%\", i, 2);\n"
            "Physical Curve(name) = {1}; Physical Curve(Sprintf(\"wall %g\", i)) = {2};",
            ""},
        Sample{"parameters",
               "DefineConstant[ r = {0.1, Min 0, Max 1, Step 0.1, Name \"Parameters/r\"} ];\n"
               "h = DefineNumber[ 2, Name \"Parameters/h\" ];",
               ""},
        Sample{"comments",
               "// SystemCall \"rm\"; is only a comment\n/* Save \"x\"; Print \"y\";\n*/ a = 1;",
               ""}),
    name_of);

class Refused : public testing::TestWithParam<Sample> {};
TEST_P(Refused, BeforeGmshSeesIt) {
  const CaseDirectory directory;
  const auto file = directory.write("geometry.geo", GetParam().text);
  expect_refused([&] { (void)guard_geometry(file); }, {file.string() + ":", GetParam().told});
}

INSTANTIATE_TEST_SUITE_P(
    Command, Refused,
    testing::Values(
        Sample{"SystemCall", "a = 1;\nSystemCall \"touch x\";", ":2: 'SystemCall' is refused"},
        Sample{"System", "System 'touch x';", "runs a command"},
        Sample{"NonBlockingSystemCall", "NonBlockingSystemCall \"x\";", "runs a command"},
        Sample{"OnelabRun", "OnelabRun(\"x\", \"y\");", "runs a command"},
        Sample{"Plugin", "Plugin(Cutmap).Run;", "'Plugin'"},
        Sample{"Save", "Save \"out.msh\";", "writes to a file"},
        Sample{"Print", "Print \"out.png\";", "writes to a file"},
        Sample{"SaveView", "Save View[0] \"out.pos\";", "writes to a file"},
        Sample{"CreateDir", "CreateDir \"x\";", "writes to a file"},
        Sample{"Printf_to_file", "Printf(\"x\") > \"out.txt\";",
               "'Printf' is refused: here it writes"},
        Sample{"Printf_appending", "i = 1; Printf(\"%g\", i) >> \"out.txt\";", "writes to a file"},
        Sample{"Printf_to_a_variable", "f = \"out\"; Printf(\"x\") > f;", "writes to a file"},
        Sample{"Error_to_file", "Error(\"x\") > \"out.txt\";", "writes to a file"},
        Sample{"ShapeFromFile", "SetFactory(\"OpenCASCADE\"); v() = ShapeFromFile(\"a.step\");",
               "reads a file"},
        Sample{"ListFromFile", "l() = ListFromFile(\"/etc/passwd\");", "reads a file"},
        Sample{"MergeWithBoundingBox", "MergeWithBoundingBox \"a.geo\";", "reads a file"},
        Sample{"FileExists", "a = FileExists(\"/etc/passwd\");", "reads a file"},
        Sample{"Open", "Open \"a.geo\";", "reads a file"},
        Sample{"Exit", "Exit;", "stops the program"},
        Sample{"Abort", "Abort;", "stops the program"},
        Sample{"Sleep", "Sleep 1000;", "stops the program"},
        Sample{"GetEnv", "h = GetEnv(\"HOME\");", "'GetEnv'"},
        Sample{"Exists", "a = Exists(b);", "'Exists'"},
        Sample{"GetString", "s = GetString(\"who\");", "'GetString'"},
        Sample{"GetValue", "x = GetValue(\"x?\", 1);", "'GetValue'"},
        Sample{"StringToName", "StringToName[\"System\"] \"x\";", "'StringToName'"},
        Sample{"S2N", "S2N[\"System\"] \"x\";", "'S2N'"},
        Sample{"SetString", "SetString(\"Solver.Executable0\", \"x\");", "'SetString'"},
        Sample{"General_option", "General.ErrorFileName = \"x\";", "'General'"},
        Sample{"Solver_option", "Solver.Executable0 = \"x\";", "'Solver'"},
        Sample{"Print_option", "Print.Text = 1;", "'Print'"},
        Sample{"command_option", "Geometry.DoubleClickedPointCommand = \"x\";", "sets a command"},
        Sample{"crashing_algorithm", "Mesh.Algorithm = 8;", "1, 2, 5 or 6"},
        Sample{"computed_algorithm", "Mesh.Algorithm = 6 + 2;", "1, 2, 5 or 6"},
        Sample{"crashing_surface_algorithm", "MeshAlgorithm Surface {1} = 8;", "'MeshAlgorithm'"},
        Sample{"ExternalProcess_field", "Field[1] = ExternalProcess; Field[1].CommandLine = \"x\";",
               "runs a command"},
        Sample{"Structured_field", "Field[1] = Structured;", "reads a file"},
        Sample{"View", "View \"x\" { SP(0, 0, 0){1}; };", "'View'"},
        Sample{"unknown_command", "Frobnicate \"x\";", "neither a command"},
        Sample{"unknown_variable", "a = b + 1;", "'b' is refused"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Disguise, Refused,
    testing::Values(
        Sample{"declared_as_a_variable", "System = 1; System \"x\";", "'System'"},
        Sample{"variable_before_a_text", "Foo = 1; Foo \"x\";", "'Foo'"},
        Sample{"variable_before_a_text_function", "Foo = 1; Foo Str(\"x\");", "'Foo'"},
        Sample{"comment_between", "System/**/\"x\";", "'System'"},
        Sample{"line_break_between", "System\n\"x\";", ":1: 'System'"},
        Sample{"backslash", "Sys\\\ntemCall \"x\";", "'\\'"},
        Sample{"other_case_is_no_command", "systemcall \"x\";", "neither a command"},
        Sample{"macro_with_computed_name", "Macro Sprintf(\"a\")\nReturn", "plain word"},
        Sample{"call_with_computed_name", "Call \"System\";", "plain word"},
        Sample{"call_with_joined_name", "Call Str(\"System\", \"Call\");", "'Str'"},
        Sample{"text_joined", "f = StrCat(\"a\", \"b\");", "'StrCat'"},
        Sample{"after_a_number", "a = 1System \"x\";", "'System'"},
        Sample{"inside_of_an_attribute", "DefineConstant[ a = {1, Include \"x\"} ];", "'Include'"},
        Sample{"index_name", "Foo~{1} = 1; Foo~{1} \"x\";", "text may not stand here"},
        Sample{"after_a_bracket", "Foo(1) = 1; Foo(1) \"x\";", "text may not stand here"},
        Sample{"EndIf_in_a_text", "If (0)\n a = \"EndIf System 'x' ;\";\nEndIf", "EndIf"},
        Sample{"Return_in_a_text", "Macro m\n a = \"Return SystemCall 'x';\";\nReturn", "Return"},
        Sample{"EndIf_in_a_name", "EXEndIf1 = 1;", "'EXEndIf1'"},
        Sample{"text_over_two_lines", "For i In {0:1} a = \"\nSystem 'x'; //\";\nEndFor",
               ":1: the text has no closing"},
        Sample{"very_long_text", "a = \"" + std::string(1100, 'x') + "System\";", "at most"},
        Sample{"very_long_name", std::string(3000, 'x') + " = 1;", "at most"},
        Sample{"very_long_number", "a = " + std::string(3000, '1') + ";", "at most"},
        Sample{"format_that_writes_memory", "Printf(\"%n\");", "conversions"},
        Sample{"format_of_a_pointer", "Printf(\"%s\", 1);", "conversions"},
        Sample{"format_too_wide", "Printf(\"%9999g\", 1);", "conversions"},
        Sample{"format_of_many", "Printf(\"%g%g%g%g%g%g%g%g%g\", 1);", "conversions"},
        Sample{"format_without_end", "Printf(\"100 %\", 1);", "conversions"},
        Sample{"format_from_a_variable", "f = \"x\"; Printf(f);", "first argument"},
        Sample{"list_without_format", "a() = {1:3}; Printf(\"a\", a());", "%g"},
        Sample{"zero_byte", std::string("a = 1;\n\0System 'x';", 19), ":2: the file holds a zero"},
        Sample{"byte_order_mark",
               "\xEF\xBB\xBF"
               "a = 1;",
               "byte order mark"},
        Sample{"letter_that_is_not_latin", "\xD0\xA1ystem 'x';", "belongs in no geometry"},
        Sample{"comment_without_end", "a = 1; /* System 'x';", "no end"},
        Sample{"shift_operator", "a = 1 >> 2;", "'>>'"},
        Sample{"scope_operator", "a = General::b;", "'General'"},
        Sample{"brackets_that_do_not_match", "Point(1) = {0, 0, 0);", "closes no bracket"},
        Sample{"bracket_left_open", "Point(1) = {0, 0, 0;", "never closed"},
        Sample{"If_without_EndIf", "If (1)\na = 1;", "'If' is refused: EndIf is missing"},
        Sample{"EndFor_without_For", "a = 1; EndFor", "'EndFor'"},
        Sample{"Else_without_If", "Else", "belongs to no If"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    FileName, Refused,
    testing::Values(Sample{"made_up", "Include Sprintf(\"a%g.geo\", 1);", "written-out file name"},
                    Sample{"variable", "f = \"a.geo\"; Merge f;", "written-out file name"},
                    Sample{"not_a_statement", "a = Include \"a.geo\";", "statement of its own"},
                    Sample{"missing", "Include \"a.geo\";", "not a file that exists"},
                    Sample{"absolute", "Include \"/etc/passwd\";", "outside"},
                    Sample{"parent", "\n\nMerge \"../a.geo\";",
                           ":3: 'Merge' is refused: \"../a.geo\" lies outside"},
                    Sample{"parent_of_a_directory", "Merge \"x/../../a.geo\";", "outside"},
                    Sample{"itself", "Include \"geometry.geo\";", "deep"}),
    name_of);

TEST(GeometryGuard, SaysWhatIsAllowed) {
  const CaseDirectory directory;
  const auto file = directory.write("geometry.geo", "SystemCall \"x\";");
  expect_refused([&] { (void)guard_geometry(file); },
                 {"points, curves, loops, surfaces", "Printf to the terminal"});
}

TEST(GeometryGuard, SpellsTheTokensWithoutComments) {
  EXPECT_EQ(guarded("a=1e3;// System\nPoint(1)={-a,.5,0};/*\n*/b=a++;"),
            "a = 1e3 ;\nPoint ( 1 ) = { - a , .5 , 0 } ;\nb = a ++ ;\n");
}

TEST(GeometryGuard, PutsIncludedFilesInTheirPlaceAndKnowsTheirLines) {
  const CaseDirectory directory;
  const auto part = directory.write("parts/part.geo", "// a part\nInclude \"deep.geo\";\nb = a;");
  const auto deep = directory.write("parts/deep.geo", "\n\na = 1;");
  const auto file = directory.write("geometry.geo",
                                    "c = 0;\nInclude \"parts/part.geo\";\nMerge 'parts/deep.geo';");
  const GuardedGeometry geometry = guard_geometry(file);
  EXPECT_EQ(geometry.text, "c = 0 ;\na = 1 ;\nb = a ;\na = 1 ;\n");
  ASSERT_EQ(geometry.lines.size(), 4U);
  EXPECT_EQ(geometry.lines[0].file, file);
  EXPECT_EQ(geometry.lines[1].file, deep);
  EXPECT_EQ(geometry.lines[1].number, 3);
  EXPECT_EQ(geometry.lines[2].file, part);
  EXPECT_EQ(geometry.lines[2].number, 3);
}

TEST(GeometryGuard, ChecksIncludedFiles) {
  const CaseDirectory directory;
  const auto part = directory.write("part.geo", "a = 1;\nSystemCall \"x\";");
  const auto file = directory.write("geometry.geo", "Include \"part.geo\";");
  expect_refused([&] { (void)guard_geometry(file); }, {part.string() + ":2:", "SystemCall"});
}

TEST(GeometryGuard, MergesMeshesUnderANameOfItsOwn) {
  const CaseDirectory directory;
  const auto mesh = directory.write("sub/wheel.msh", "anything");
  const auto file = directory.write("geometry.geo", "Merge \"sub/wheel.msh\";");
  const GuardedGeometry geometry = guard_geometry(file);
  EXPECT_EQ(geometry.text, "Merge \"" + merged_name(0) + "\";\n");
  EXPECT_EQ(geometry.meshes, std::vector<std::filesystem::path>{mesh});
}

TEST(GeometryGuard, RefusesFilesOfOtherKinds) {
  const CaseDirectory directory;
  (void)directory.write("wheel.step", "x");
  (void)directory.write("wheel.msh", "x");
  const auto step = directory.write("a.geo", "Merge \"wheel.step\";");
  expect_refused([&] { (void)guard_geometry(step); }, {"wheel.step", "no .geo file"});
  const auto included = directory.write("b.geo", "Include \"wheel.msh\";");
  expect_refused([&] { (void)guard_geometry(included); }, {"wheel.msh", "no .geo file"});
}

TEST(GeometryGuard, FollowsALinkInsideTheDirectoryAndRefusesOneThatLeavesIt) {
  const CaseDirectory outside;
  const auto secret = outside.write("secret.geo", "a = 1;");
  const CaseDirectory directory;
  const auto part = directory.write("part.geo", "a = 1;");
  const auto file = directory.write("geometry.geo", "Include \"link.geo\";");
  std::filesystem::create_symlink(part, directory.path() / "link.geo");
  EXPECT_EQ(guard_geometry(file).text, "a = 1 ;\n");
  std::filesystem::remove(directory.path() / "link.geo");
  std::filesystem::create_symlink(secret, directory.path() / "link.geo");
  expect_refused([&] { (void)guard_geometry(file); }, {"link.geo", "outside"});
}

TEST(GeometryGuard, RefusesALinkedDirectoryThatLeavesTheDirectory) {
  const CaseDirectory outside;
  (void)outside.write("secret.geo", "a = 1;");
  const CaseDirectory directory;
  std::filesystem::create_directory_symlink(outside.path(), directory.path() / "parts");
  const auto file = directory.write("geometry.geo", "Include \"parts/secret.geo\";");
  expect_refused([&] { (void)guard_geometry(file); }, {"parts/secret.geo", "outside"});
}

TEST(GeometryGuard, RefusesGeometriesThatGrowWithoutBoundByIncluding) {
  const CaseDirectory directory;
  std::string part = "a = 1;";
  for (const char* const name : {"1.geo", "2.geo", "3.geo", "4.geo", "5.geo"}) {
    (void)directory.write(name, part);
    part.clear();
    for (int i = 0; i < 20; ++i) part += std::string("Include \"") + name + "\";\n";
  }
  const auto file = directory.write("geometry.geo", part);
  expect_refused([&] { (void)guard_geometry(file); }, {"more than", "files", ".msh"});
}

TEST(GeometryGuard, NamesAFileThatDoesNotExist) {
  expect_refused([] { (void)guard_geometry("/nowhere/at/all.geo"); },
                 {"/nowhere/at/all.geo", "no such file"});
}

}  // namespace
}  // namespace geneva::mesh
