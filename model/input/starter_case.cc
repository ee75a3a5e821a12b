#include "model/input/starter_case.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"
#include "model/input/nearest_word.h"
#include "model/mechanisms/mechanism_type.h"

namespace geneva::model {

namespace {

using base::Dimension;
using base::UnitSystem;

constexpr const char* geometry = "geometry";
constexpr int usual_stations = 6;

/// An SI value as the case file shows it, to three digits.
std::string quantity(const UnitSystem units, const Dimension dimension, const double value) {
  const base::OutputUnit unit = base::output_unit(units, dimension);
  const double rounded = std::stod(fmt::format("{:.3g}", value * unit.factor));
  return fmt::format("{:g} {}", rounded, unit.name);
}

/// "set NAME = VALUE" lines with the signs below each other, and comments.
class Lines {
 public:
  explicit Lines(const int indent) : indent_(static_cast<std::size_t>(indent), ' ') {}

  Lines& comment(const std::string& text) {
    lines_.emplace_back("# " + text, "");
    return *this;
  }
  Lines& set(const std::string& name, const std::string& value) {
    lines_.emplace_back(name, value);
    widest_ = std::max(widest_, name.size());
    return *this;
  }
  [[nodiscard]] std::string text() const {
    std::string result;
    for (const auto& [name, value] : lines_)
      result += indent_ +
                (value.empty() ? name : fmt::format("set {:<{}} = {}", name, widest_, value)) +
                '\n';
    return result;
  }

 private:
  std::string indent_;
  std::vector<std::pair<std::string, std::string>> lines_;
  std::size_t widest_ = 0;
};

/// Sizes that a type of mechanism needs, and what they are.
std::string sizes_of(const Starter& starter) {
  const auto length = [&](const double value) {
    return quantity(starter.units, Dimension::length, value);
  };
  Lines lines(2);
  if (starter.type == "external" || starter.type == "internal") {
    lines
        .comment(starter.type == "external" ? "Diameter over the tips of the arms. Pin, thickness, "
                                              "slots and locking disc follow "
                                              "from it by"
                                            : "Diameter of the inner rim, where the slots open. "
                                              "Pin, thickness and slots follow "
                                              "from it by")
        .comment(
            "Johnson's proportions, unless they are given (Pin diameter, Wheel thickness, Slot "
            "clearance, ...).")
        .set("Wheel diameter", length(0.12));
    return lines.text();
  }
  if (starter.type == "spherical")
    lines.comment("Radius of the sphere on which the pin moves, and the angle between the shafts.")
        .set("Sphere radius", length(0.08))
        .set("Shaft angle", "90 deg");
  else if (starter.type == "long dwell")
    lines.comment("A chain around two sprockets of this radius carries the pin.")
        .set("Crank radius", length(0.04))
        .set("Sprocket spacing", length(0.12))
        .set("Sprocket line", "along line of centres");
  lines.set("Pin diameter", length(0.012)).set("Wheel thickness", length(0.012));
  return lines.text();
}

/// The linkage of a four-bar mechanism; nothing of the others.
std::string linkage_of(const Starter& starter) {
  if (starter.type != "four-bar") return "";
  const auto length = [&](const double value) {
    return quantity(starter.units, Dimension::length, value);
  };
  Lines lines(4);
  lines.set("Crank", length(0.04))
      .set("Coupler", length(0.12))
      .set("Rocker", length(0.12))
      .set("Frame", length(0.1))
      .comment("The pin sits on the coupler, at this distance and angle from the crank's joint.")
      .set("Coupler point distance", length(0.12))
      .set("Coupler point angle", "90 deg")
      .set("Assembly", "open")
      .comment("Where the wheel is, seen from the crank's axis.")
      .set("Wheel direction", "150 deg");
  return "\n  subsection Linkage\n" + lines.text() + "  end\n";
}

std::string load_of(const Starter& starter, const bool is_drawn) {
  Lines lines(2);
  lines
      .comment(
          "The driver turns evenly. The contact is solved at one of its angles; 0 is the middle of "
          "the")
      .comment("engagement, '-20 deg' an instant before it.")
      .set("Driver speed", "300 rpm")
      .set("Driver angle", "at maximum pin force")
      .comment("What the wheel drives: an inertia, and a friction that brakes it.")
      .set("Load inertia", quantity(starter.units, Dimension::inertia, 0.002))
      .set("Friction moment", quantity(starter.units, Dimension::moment, 0.5));
  if (!is_drawn)
    lines
        .comment(
            "This wheel is not drawn: its inertia is given, and the pin presses on a block of slot "
            "wall.")
        .set("Wheel inertia", quantity(starter.units, Dimension::inertia, 0.001))
        .set("Contact model", "local");
  return lines.text();
}

std::string material(const std::string& section, const std::string& name) {
  return fmt::format("\n  subsection {}\n    set Material = {}\n  end\n", section, name);
}

std::string heading(const std::string& what, const std::string& more) {
  return fmt::format(
      "# {}\n# 'geneva run' solves it and writes the report; {}'geneva parameters' lists\n"
      "# every parameter with its meaning and default.\n",
      what, more);
}

std::string mechanism_text(const Starter& starter) {
  const std::string name = fmt::format("{} Geneva mechanism, {} stations", starter.type,
                                       starter.stations.value_or(usual_stations));
  const bool is_drawn = starter.type == "external" || starter.type == "internal";
  Lines general(0);
  general.set("Title", name)
      .set("Model", "mechanism")
      .comment("Of the results: SI, mm-N or in-lbf. Every input has its own unit.")
      .set("Output units", base::name_of(starter.units))
      .comment("Of the peak contact pressure.")
      .set("Accuracy", "0.5 %");
  Lines kind(2);
  kind.set("Type", starter.type)
      .set("Stations", std::to_string(starter.stations.value_or(usual_stations)));
  const std::string more = "'geneva kinematics' shows its motion and forces. ";
  return heading(name, more) + general.text() + "\nsubsection Mechanism\n" + kind.text() +
         sizes_of(starter) + "\n" + load_of(starter, is_drawn) + linkage_of(starter) +
         "\n  # 'geneva materials' lists the names; single values can be given instead or "
         "besides.\n" +
         material("Pin material", "100Cr6 hardened").substr(1) +
         material("Wheel material", "42CrMo4 quenched and tempered") + "end\n";
}

std::string geometry_prm(const UnitSystem units) {
  Lines general(0);
  general.set("Title", "cylinder on a block")
      .set("Model", "geometry")
      .comment("Of the results: SI, mm-N or in-lbf. Every input has its own unit.")
      .set("Output units", base::name_of(units))
      .comment("Of the peak contact pressure.")
      .set("Accuracy", "0.5 %");
  Lines section(2);
  section.comment("Of the numbers in the geometry's file.")
      .set("Length unit", "mm")
      .set("Plane", "plane strain")
      .set("Thickness", quantity(units, Dimension::length, 0.01))
      .comment(
          "Bodies and surfaces by the names that the file gives them: Physical Surface, Physical "
          "Curve.")
      .set("Bodies", "cylinder, block")
      .set("Supports", "block bottom: fixed")
      .set("Loads", "cylinder core")
      .comment("The first surface presses on the second.")
      .set("Contact pairs", "cylinder surface -> block top");
  Lines load(4);
  load.comment("The whole core moves as a rigid body under this force.")
      .set("Type", "force")
      .set("Value", quantity(units, Dimension::force, 2000.))
      .set("Direction", "0, -1");
  return heading("A cylinder on a block, drawn in geometry.geo: make it yours.", "") +
         general.text() + "\nsubsection Geometry\n" + section.text() +
         material("Body cylinder", "100Cr6 hardened") +
         material("Body block", "42CrMo4 quenched and tempered") +
         "\n  subsection Load cylinder core\n" + load.text() + "  end\nend\n";
}

/// Coarse is enough: the program refines where the contact is.
constexpr const char* cylinder_on_block =
    R"(// A cylinder of radius R on a block; they touch at the origin. Lengths in mm.
// The mesh may be coarse: the program refines it where the contact is, and follows the circles.
R = 10;
core = R / 2;
W = 30;

Point(1) = {0, R, 0};
Point(2) = {0, 0, 0};
Point(3) = {R, R, 0};
Point(4) = {0, 2 * R, 0};
Point(5) = {-R, R, 0};
Point(6) = {0, R - core, 0};
Point(7) = {core, R, 0};
Point(8) = {0, R + core, 0};
Point(9) = {-core, R, 0};
Circle(1) = {2, 1, 3};
Circle(2) = {3, 1, 4};
Circle(3) = {4, 1, 5};
Circle(4) = {5, 1, 2};
Circle(5) = {6, 1, 7};
Circle(6) = {7, 1, 8};
Circle(7) = {8, 1, 9};
Circle(8) = {9, 1, 6};
Curve Loop(1) = {1, 2, 3, 4};
Curve Loop(2) = {5, 6, 7, 8};
Plane Surface(1) = {1, 2};

Point(11) = {-W, -W, 0};
Point(12) = {W, -W, 0};
Point(13) = {W, 0, 0};
Point(14) = {-W, 0, 0};
Line(11) = {11, 12};
Line(12) = {12, 13};
Line(13) = {13, 14};
Line(14) = {14, 11};
Curve Loop(3) = {11, 12, 13, 14};
Plane Surface(2) = {3};
Mesh.MeshSizeMax = 4;

// The names by which case.prm knows bodies and surfaces.
Physical Surface("cylinder") = {1};
Physical Curve("cylinder surface") = {1, 2, 3, 4};
Physical Curve("cylinder core") = {5, 6, 7, 8};
Physical Surface("block") = {2};
Physical Curve("block top") = {13};
Physical Curve("block bottom") = {11};
)";

}  // namespace

std::vector<std::string> starter_types() {
  std::vector<std::string> types;
  for (const MechanismKind& kind : mechanism_kinds()) types.push_back(kind.name);
  types.emplace_back(geometry);
  return types;
}

std::vector<StarterFile> starter_case(const Starter& starter) {
  const std::vector<std::string> types = starter_types();
  if (std::find(types.begin(), types.end(), starter.type) == types.end()) {
    const auto nearest = nearest_word(starter.type, types);
    throw base::InputError(fmt::format(
        "{}: there is no such type{}; one of {} is wanted", base::in_quotes(starter.type),
        nearest ? fmt::format(" (did you mean '{}'?)", *nearest) : "", listed(types)));
  }
  if (starter.type == geometry && starter.stations)
    throw base::InputError(
        "--stations: a geometry is no wheel; leave it away, or name another type");
  if (starter.type == geometry)
    return {{"case.prm", geometry_prm(starter.units)}, {"geometry.geo", cylinder_on_block}};
  return {{"case.prm", mechanism_text(starter)}};
}

}  // namespace geneva::model
