#include "mesh/geometry_words.h"

#include <map>
#include <set>

namespace geneva::mesh {

namespace {

using Words = std::set<std::string_view>;

/// Reserved words of Gmsh's language that draw, mesh or calculate.
const Words& commands() {
  static const Words words{
      // shapes
      "Point", "Line", "Curve", "Circle", "Ellipse", "Ellipsis", "Spline", "BSpline", "Bezier",
      "CatmullRom", "Nurbs", "Knots", "Order", "Wire", "Plane", "Surface", "Ruled", "Volume",
      "Rectangle", "Disk", "Compound", "Physical", "Block", "Box", "Cylinder", "Sphere", "Fillet",
      "Chamfer",
      // transformations
      "Translate", "Rotate", "Symmetry", "Dilate", "Affine", "Extrude", "Layers", "Recombine",
      "Delete", "Recursive", "Coherence", "Split", "Reverse", "ReverseMesh", "Unique",
      "BooleanUnion", "BooleanFuse", "BooleanIntersection", "BooleanCommon", "BooleanDifference",
      "BooleanCut", "BooleanFragments", "BooleanCoherence", "BooleanSection", "BoundingBox", "In",
      "SetFactory", "SetMaxTag", "Show", "Hide", "Color", "Mass", "CenterOfMass",
      // meshing
      "Characteristic", "Length", "MeshSize", "MeshSizeFromBoundary", "Transfinite", "Using",
      "Periodic", "Smoother", "Field", "RefineMesh", "RecombineMesh", "Degenerated",
      // flow and output
      "For", "EndFor", "If", "ElseIf", "Else", "EndIf", "Macro", "Function", "Return", "Call",
      "Printf", "Warning", "Error", "Sprintf", "DefineConstant", "DefineNumber",
      // numbers
      "newp", "newl", "newc", "newll", "news", "newsl", "newv", "newf", "newreg", "Pi", "Exp",
      "Log", "Log10", "Sqrt", "Sin", "Asin", "ArcSin", "Cos", "Acos", "ArcCos", "Tan", "Atan",
      "ArcTan", "Atan2", "ArcTan2", "Sinh", "Cosh", "Tanh", "Fabs", "Abs", "Floor", "Ceil", "Round",
      "Fmod", "Modulo", "Hypot", "Rand", "Max", "Min", "List", "LinSpace", "LogSpace", "Catenary",
      "Find", "GMSH_MAJOR_VERSION", "GMSH_MINOR_VERSION", "GMSH_PATCH_VERSION"};
  return words;
}

/// Words that Gmsh does not reserve but understands in certain places.
const Words& context_words() {
  static const Words words{
      "Loop", "Progression", "Power", "Bump", "Beta", "Left", "Right", "Alternate", "AlternateLeft",
      "AlternateRight", "Duplicata", "Boundary", "CombinedBoundary", "PointsOf", "Embedded",
      "Physicals", "Meshes", "Background", "BoundaryLayer", "Mesh", "Geometry",
      // types of fields
      "Attractor", "AttractorAnisoCurve", "Ball", "Constant", "Curvature", "Distance", "Extend",
      "Frustum", "Gradient", "IntersectAniso", "Laplacian", "LonLat", "MathEval", "MathEvalAniso",
      "MaxEigenHessian", "Mean", "MinAniso", "Octree", "Param", "Restrict", "Threshold",
      // attributes of DefineConstant
      "Name", "Label", "Help", "Units", "Step", "Range", "Choices", "ReadOnly", "Visible",
      "Highlight", "Closed",
      // colours
      "Black", "Blue", "Brown", "Cyan", "Gray", "Green", "Grey", "Magenta", "Orange", "Pink",
      "Purple", "Red", "White", "Yellow"};
  return words;
}

const std::map<std::string_view, const char*>& forbidden() {
  static const char* const runs = "it runs a command on this machine";
  static const char* const writes = "it writes to a file or directory";
  static const char* const reads = "it reads a file of any kind or place";
  static const char* const asks = "it depends on the machine or the user";
  static const char* const hides = "it makes up names or texts that cannot be checked";
  static const char* const stops = "it stops the program";
  static const char* const elsewhere = "it is for looking at results";
  static const char* const sets = "it changes settings other than Mesh.* and Geometry.*";
  static const std::map<std::string_view, const char*> words{
      {"SystemCall", runs},
      {"System", runs},
      {"OnelabRun", runs},
      {"NonBlockingSystemCall", runs},
      {"ExternalProcess", runs},
      {"Plugin", runs},
      {"OnelabAction", runs},
      {"Solver", runs},
      {"Slide", elsewhere},
      {"Draw", elsewhere},
      {"Print", writes},
      {"Save", writes},
      {"CreateDir", writes},
      {"SendToServer", writes},
      {"View", elsewhere},
      {"MergeWithBoundingBox", reads},
      {"ShapeFromFile", reads},
      {"ListFromFile", reads},
      {"FileExists", reads},
      {"Structured", reads},
      {"PostView", reads},
      {"Open", reads},
      {"GetEnv", asks},
      {"GetString", asks},
      {"GetNumber", asks},
      {"GetValue", asks},
      {"GetStringValue", asks},
      {"GetForced", asks},
      {"GetForcedStr", asks},
      {"Exists", asks},
      {"OnelabClient", asks},
      {"Today", asks},
      {"Sleep", stops},
      {"GmshExecutableName", asks},
      {"Exit", stops},
      {"Abort", stops},
      {"StringToName", hides},
      {"S2N", hides},
      {"NameToString", hides},
      {"N2S", hides},
      {"Str", hides},
      {"StrCat", hides},
      {"StrReplace", hides},
      {"StrSub", hides},
      {"StrChoice", hides},
      {"StrPrefix", hides},
      {"StrRelative", hides},
      {"UpperCase", hides},
      {"LowerCase", hides},
      {"LowerCaseIn", hides},
      {"DefineString", hides},
      {"Parametric", hides},
      {"SetNumber", sets},
      {"SetString", sets},
      {"General", sets},
      {"PostProcessing", sets},
      {"Options", sets},
      {"MeshAlgorithm", "some algorithms of this Gmsh crash"},
      {"NewModel", sets},
      {"OptimizeMesh", sets}};
  return words;
}

}  // namespace

bool is_command(std::string_view word) { return commands().count(word) != 0; }

bool is_context_word(std::string_view word) { return context_words().count(word) != 0; }

const char* harm_of(std::string_view word) {
  const auto found = forbidden().find(word);
  return found == forbidden().end() ? nullptr : found->second;
}

}  // namespace geneva::mesh
