#include "model/input/parameters.h"

#include <utility>

#include "loads/pi.h"
#include "model/mechanisms/mechanism_type.h"

namespace geneva::model {

namespace {

/// May be left empty.
QuantityRule whole_or_nothing(const double lower, const double upper, const std::string& text) {
  QuantityRule rule = whole(lower, upper, text);
  rule.words = {""};
  return rule;
}

using base::Dimension;

void append(std::vector<Parameter>& parameters, std::vector<Parameter> more) {
  for (Parameter& parameter : more) parameters.push_back(std::move(parameter));
}

/// Of a case or of the collection.
std::vector<Parameter> elastic_parameters(const SectionPath& section) {
  const Range poissons_ratio{-1., 0.4999, false, true, "greater than -1 and at most 0.4999"};
  return {
      {section, "Young's modulus", "207 GPa", positive(Dimension::stress),
       "Modulus of elasticity E. The default is that of steel."},
      {section, "Poisson's ratio", "0.3", quantity(Dimension::dimensionless, poissons_ratio),
       "Poisson's ratio nu, up to 0.4999 (nearly incompressible). The default is that of steel."},
      {section, "Density", "7850 kg/m^3", positive(Dimension::density),
       "Mass density. The default is that of steel."},
      {section, "Yield strength", "", positive(Dimension::stress, {""}),
       "Von Mises stress at which the material yields; if given, the safety factor against it is "
       "reported."},
      {section, "Fatigue strength", "", positive(Dimension::stress, {""}),
       "Maximum tensile stress that the material bears any number of times, from nought to maximum "
       "(pulsating), with the surface and size of the part; if given, the safety factor of the "
       "maximum tensile stress away from the contact is reported."}};
}

/// Of a case: by name, by value, or both.
std::vector<Parameter> material_parameters(const SectionPath& section) {
  std::vector<Parameter> parameters{
      {section, names::material, "", TextRule{"a name of 'geneva materials', or nothing"},
       "Material whose typical values stand for those that are not given here: elastic constants, "
       "density, yield and fatigue strength, and the contact pressure that it allows."}};
  append(parameters, elastic_parameters(section));
  return parameters;
}

/// A length that follows from a rule unless it is given.
Parameter ruled_length(const std::string& name, const std::string& help,
                       const Range& range = greater_than_zero()) {
  return {{names::mechanism},
          name,
          names::default_word,
          quantity(Dimension::length, range, {names::default_word}),
          help};
}

/// 'name': what it is, of each type.
std::string meaning_of_kinds() {
  std::string text;
  for (const MechanismKind& kind : mechanism_kinds())
    text += (text.empty() ? "'" : " '") + kind.name + "': " + kind.help;
  return text;
}

ChoiceRule choice_of_kinds() {
  ChoiceRule rule;
  for (const MechanismKind& kind : mechanism_kinds()) rule.words.push_back(kind.name);
  return rule;
}

std::vector<Parameter> kind_parameters() {
  const SectionPath section{names::mechanism};
  std::vector<Parameter> parameters{
      {section, "Type", mechanism_kinds().front().name, choice_of_kinds(), meaning_of_kinds()}};
  for (const MechanismKind& kind : mechanism_kinds())
    if (kind.section == section) append(parameters, kind.parameters);
  append(parameters,
         {{section, "Pins", "1", whole(1, 24, "from 1 to 24"),
           "Number of equally spaced pins on the driver."},
          {section, "Pin angles", "", TextRule{"angles with their units, separated by commas"},
           "Angles of the pins on the driver where they are not equally spaced, against its sense "
           "of rotation; the first is 0 deg. Instead of 'Pins'."}});
  return parameters;
}

/// Those in subsections of their own.
std::vector<Parameter> kind_subsections() {
  std::vector<Parameter> parameters;
  for (const MechanismKind& kind : mechanism_kinds())
    if (kind.section != SectionPath{names::mechanism}) append(parameters, kind.parameters);
  return parameters;
}

std::vector<Parameter> size_parameters() {
  const SectionPath section{names::mechanism};
  const QuantityRule size = positive(Dimension::length, {""});
  const std::string one_of =
      " Exactly one of wheel diameter, crank radius and centre distance is given, unless the type "
      "has a size of its own (subsections below).";
  return {
      {section, "Stations", "", whole(3, 24, "from 3 to 24"),
       "Number n of the wheel's slots: the wheel turns 1/n of a turn with each turn of the driver.",
       true},
      {section, "Wheel diameter", "", size,
       "Diameter D of the wheel's rim; of an internal wheel the inner one, where its slots open." +
           one_of},
      {section, "Crank radius", "", size,
       "Distance r from the driver's axis to the pin's axis: r = (D/2) tan(pi/n). Long dwell: "
       "pitch "
       "radius of the sprockets." +
           one_of},
      {section, "Centre distance", "", size,
       "Distance c from the driver's axis to the wheel's axis: c = (D/2)/cos(pi/n)." + one_of},
      ruled_length("Pin diameter",
                   "Diameter d of the pin. Default: k2 D, with Johnson's k2 for the number of "
                   "stations; where no wheel is drawn D is twice the pin's distance at entry."),
      ruled_length("Wheel thickness",
                   "Thickness t of the wheel. Default: k3 D, with Johnson's k3 for the number of "
                   "stations and D as for the pin."),
      ruled_length("Slot clearance",
                   "Slot width minus pin diameter. Default: 0. Either the clearance or the width "
                   "is given.",
                   zero_or_greater()),
      ruled_length("Slot width",
                   "Distance between the slot's parallel walls. Default: pin diameter plus slot "
                   "clearance."),
      ruled_length(
          "Slot depth",
          "From the rim to the end of the slot's round bottom. Default: D/2 - (c "
          "- r) + half the slot width, of an internal wheel c + r - D/2 + that, so that the bottom "
          "is concentric with the pin where it is deepest in its slot."),
      ruled_length("Locking radius",
                   "Radius of the locking arcs between the slots. Default: k4 D, with Johnson's k4 "
                   "for the number of stations."),
      ruled_length("Bore radius",
                   "Radius of the hole at the wheel's axis, where the wheel is held. Default: the "
                   "smaller of 0.1 D and half the radius of the slots' lowest point."),
      ruled_length(
          "Rim radius",
          "Outer radius of an internal wheel, where it is held. Default: D/2 plus the slot "
          "depth plus 0.15 D."),
      ruled_length(
          "Pin core radius",
          "Radius of the pin's core, where the driver holds it. Default: a quarter of the "
          "pin diameter, of a roller with a bore clearance a quarter of its stud's. In 3-D "
          "only with Held at = core.")};
}

std::vector<Parameter> motion_parameters() {
  const SectionPath section{names::mechanism};
  const std::vector<std::string> angles{names::at_maximum_acceleration, names::at_maximum_force};
  const std::string constant = " Only with Driver motion = constant.";
  return {{section, "Driver motion", names::constant,
           ChoiceRule{{names::constant, names::table, names::cycloidal_carrier,
                       names::harmonic_carrier, names::cycloidal_cross, names::harmonic_cross}},
           "'constant': constant speed, or constant acceleration. 'table': the angles of a file. "
           "'... on the carrier': the driver goes through each engagement by a law of motion; "
           "'... on the cross': it moves so that the wheel turns by the law."},
          {section, "Driver speed", "", positive(Dimension::angular_speed, {""}),
           "Angular speed of the driver; where it accelerates, that at driver angle 0." + constant},
          {section, "Driver acceleration", "0 rad/s^2", quantity(Dimension::angular_acceleration),
           "Angular acceleration of the driver; negative: it slows down." + constant},
          {section, "Motion time", "", positive(Dimension::time, {""}),
           "Time in which the pin is in the slot. Only with a law of motion."},
          {section, "Motion table", "", TextRule{"the name of a file in the case directory"},
           "Comma-separated file with a heading of two names with units, 'time [s], angle [deg]', "
           "and a row for each instant; angle 0 is midway through the first pin's engagement. Only "
           "with Driver motion = table."},
          {section, "Driver angle", names::at_maximum_acceleration,
           quantity(Dimension::angle, Range(), angles),
           "Where the driver stands, from the line of centres; negative before the pin reaches "
           "it."}};
}

std::vector<Parameter> contact_model_parameters() {
  const SectionPath section{names::mechanism};
  return {
      {section, "Contact model", names::full_wheel, ChoiceRule{{names::full_wheel, names::local}},
       "'full wheel': the whole slotted wheel, external or internal. 'local': the pin on a "
       "block of slot wall, held at its back, for every mechanism."},
      ruled_length("Block width",
                   "Width of the block along the slot. Default: four pin diameters. Only with "
                   "Contact model = local."),
      ruled_length("Block depth",
                   "Depth of the block behind the slot wall. Default: two pin diameters. Only "
                   "with Contact model = local.")};
}

/// The pin along its length, which a plane model does not know.
std::vector<Parameter> pin_parameters() {
  const SectionPath section{names::mechanism, names::pin};
  const std::string space = " Only with Dimension = 3.";
  const QuantityRule length = positive(Dimension::length, {""});
  const Range tilt{-loads::pi / 18., loads::pi / 18., true, true, "from -10 to 10 deg"};
  const Range tolerance{0., loads::pi / 18., true, true, "from 0 to 10 deg"};
  return {
      {section, "Held at", names::one_end,
       ChoiceRule{{names::one_end, names::both_ends, names::core}},
       "'one end': the pin is a cantilever. 'both ends': it is held on both sides of the wheel; "
       "one half is solved, unless a tilt or a table tells the ends apart. "
       "'core': its core is rigid over the whole length. With Dimension = 2 the core is rigid in "
       "any case: the parameter says at which root force, moment and stresses of a beam are told."},
      {section, "Root gap", names::default_word,
       quantity(Dimension::length, zero_or_greater(), {names::default_word}),
       "Free length from the wheel to where the pin is held. Default: a quarter of the pin "
       "diameter; with Held at = core there is none. With Dimension = 2 for the root's force, "
       "moment and "
       "stresses only."},
      {section, "Overhang", names::default_word,
       quantity(Dimension::length, zero_or_greater(), {names::default_word}),
       "Length beyond the wheel at every free end; none with Held at = both ends. Default: a "
       "quarter of the pin diameter. Either the overhang or the length is given."},
      {section, "Length", "", length,
       "Length of the pin from end to end; where it is held, from there. Not with Held at = both "
       "ends."},
      {section, "End chamfer", "0 m", quantity(Dimension::length, zero_or_greater()),
       "Leg of the 45 degree chamfer at the pin's free ends. Not with Held at = both ends."},
      {section, "Profile", names::cylindrical,
       ChoiceRule{{names::cylindrical, names::crown, names::logarithmic, names::table}},
       "Outline of the pin along its length: 'crown': a circular arc. 'logarithmic': by which a "
       "line contact of finite length carries its design load evenly (Lundberg; Johns and Gohar). "
       "'table': the heights of a file."},
      {section, "Crown radius", "", length,
       "Radius of the arc, which reaches at least from the middle of the wheel to the pin's end. "
       "Only with Profile = crown."},
      {section, "Profile load", names::default_word,
       positive(Dimension::force, {names::default_word}),
       "Design load of the logarithmic profile. Default: the pin force. Either the load or the "
       "amplitude is given."},
      {section, "Profile amplitude", "", length,
       "Factor A of the logarithm; the design load F over the length L gives F/(pi L E*). Only "
       "with Profile = logarithmic."},
      {section, "Profile length", names::default_word,
       positive(Dimension::length, {names::default_word}),
       "Length over which the logarithmic profile is to carry evenly. Default: the wheel's "
       "thickness."},
      {section, "Profile table", "", TextRule{"the name of a file in the case directory"},
       "Comma-separated file with the heading 'z [mm], height [um]' in any units of length and a "
       "row for each point: places from the middle of the wheel's thickness, increasing towards "
       "where the pin is held, and heights of the outline (lower where the pin is thinner). Only "
       "with Profile = table."},
      {section, "Tilt", "0 deg", quantity(Dimension::angle, tilt),
       "By which the pin leans; positive: its free end towards the driving wall. In a whole wheel "
       "the 'Slot clearance' has to leave room for it." +
           space},
      {section, "Tilt tolerance", "0 deg", quantity(Dimension::angle, tolerance),
       "By which the tilt may be more or less, for 'geneva design --crown', which looks for the "
       "profile that bears all of them best." +
           space},
      {section, "Load range", "", QuantityRule{Dimension::force, zero_or_greater(), {""}, 2, 2},
       "Least and greatest pin force, for 'geneva design --crown'. Default: the pin force alone." +
           space},
      {section, "Slot edge", names::sharp,
       ChoiceRule{{names::sharp, names::chamfered, names::rounded}},
       "Edge of the slot on both faces of the wheel."},
      {section, "Slot edge size", "", length,
       "Leg of the 45 degree chamfer, or radius. Only with a chamfered or rounded slot edge."}};
}

std::vector<Parameter> inertia_parameters() {
  const SectionPath section{names::mechanism};
  const std::string cylinder = " Only with Load inertia = solid cylinder.";
  const std::string only_roller = " Only with Pin type = roller.";
  return {
      {section, "Wheel inertia", names::from_geometry,
       positive(Dimension::inertia, {names::from_geometry, names::johnson}),
       "Moment of inertia of the wheel about its axis. 'from geometry': that of the drawn wheel; "
       "'Johnson': k5 rho D^5, for 3 to 10 stations."},
      {section, "Load inertia", "",
       quantity(Dimension::inertia, zero_or_greater(), {names::solid_cylinder}),
       "Moment of inertia of what the wheel drives, about the wheel's axis. 'solid cylinder': that "
       "of a cylinder with the load's diameter, length and density.",
       true},
      {section, "Load diameter", "", positive(Dimension::length, {""}),
       "Diameter of the cylinder." + cylinder},
      {section, "Load length", "", positive(Dimension::length, {""}),
       "Length of the cylinder." + cylinder},
      {section, "Load density", "", positive(Dimension::density, {""}),
       "Mass density of the cylinder." + cylinder},
      {section, "Friction moment", "0 N.m", quantity(Dimension::moment, zero_or_greater()),
       "Moment on the wheel's axis against its motion."},
      {section, "External torque", "0 N.m", quantity(Dimension::moment),
       "Torque of the driven machine on the wheel's axis, against its motion; negative: with it."},
      {section, "Instants", "", whole_or_nothing(3., 1e4, "from 3 to 10000, or nothing"),
       "Of 'geneva cycle', at equal steps of time over each engagement, from entry to exit. Empty: "
       "as many as the pin force needs, and those at which force, pressure or slip is greatest."},
      {section, "Slot friction", "0", quantity(Dimension::dimensionless, zero_or_greater()),
       "Coefficient of friction between slot wall and a pin that is fixed to its carrier, in the "
       "pin "
       "force and in the contact, where the pin slides along the wall. Only with Pin type = "
       "fixed."},
      {section, "Pin type", names::fixed, ChoiceRule{{names::fixed, names::roller}},
       "'fixed': the pin is one with what carries it (crank, chain link, coupler) and slides on "
       "the "
       "wall with its surface. 'roller': it turns freely on a stud, rolls on the wall and slides "
       "in "
       "its bore."},
      {section, "Roller bore diameter", "", positive(Dimension::length, {""}),
       "Diameter of the bore with which the roller turns on its stud, less than the pin "
       "diameter." +
           only_roller},
      {section, "Roller bore friction", "0", quantity(Dimension::dimensionless, zero_or_greater()),
       "Coefficient of friction of roller and stud, for the pin force and for the limits of the "
       "bore's "
       "pressure." +
           only_roller},
      {section, "Roller bore clearance", "", quantity(Dimension::length, zero_or_greater(), {""}),
       "Bore diameter less the stud's, at most a tenth of the bore; if given, roller and stud are "
       "bodies of their own with a contact between them, in the plane (Dimension = 2)." +
           only_roller}};
}

std::vector<Parameter> design_parameters() {
  const SectionPath section{names::mechanism, names::design};
  const std::string only = " Only with a shaft.";
  return {
      {section, "Given lengths", names::scale_with_the_wheel,
       ChoiceRule{{names::scale_with_the_wheel, names::stay_as_given}},
       "What 'geneva design' does with the lengths that the case gives (pin diameter, thickness, "
       "slot, arcs, bore) when it draws the wheel with other diameters."},
      {section, names::shaft, "",
       TextRule{"a list of 'DIAMETER x LENGTH', separated by commas, for example '0.375 in x 5 in, "
                "1 in x 3 in'"},
       "Shaft between wheel and load for 'geneva design', one entry for each diameter; without it "
       "no vibration is worked out."},
      {section, "Shaft shear modulus", "79.6 GPa", positive(Dimension::stress),
       "Shear modulus G of the shaft. The default is that of steel."},
      {section, "Shaft density", "7850 kg/m^3", positive(Dimension::density),
       "Mass density of the shaft. The default is that of steel."},
      {section, "Amplitude radius", "", positive(Dimension::length, {""}),
       "Distance from the axis at which the double amplitude of the load's vibration is told. "
       "Default: half the load diameter, if the load is a solid cylinder." +
           only},
      {section, "Add shaft inertia", "false", ChoiceRule{{"false", "true"}},
       "Whether 'geneva design' adds the shaft's inertia, all of it, to the load's in pin force "
       "and optimum wheel; 'geneva run' never does." +
           only}};
}

std::vector<Parameter> body_parameters(const std::string& body) {
  const SectionPath section = body_section(body);
  const Range speed{-1e6, 1e6, true, true, "from -1e6 to 1e6 rad/s"};
  std::vector<Parameter> parameters = material_parameters(section);
  append(parameters,
         {{section, "Body force", "0 N/m^3, 0 N/m^3", vector_of(Dimension::force_per_volume),
           "Force per volume of the body in x and y, in 3-D in x, y and z."},
          {section, "Gravity", "0 m/s^2, 0 m/s^2", vector_of(Dimension::acceleration),
           "Acceleration of gravity in x and y, in 3-D in x, y and z: density times gravity is "
           "added "
           "to the body force."},
          {section, "Angular speed", "0 rad/s", quantity(Dimension::angular_speed, speed),
           "Of the body about the origin, in 3-D about the z axis, in an axisymmetric model about "
           "the axis of revolution: its centrifugal force is added to the body force."}});
  return parameters;
}

std::vector<Parameter> load_parameters(const std::string& surface) {
  const SectionPath section = load_section(surface);
  return {
      {section, "Type", "pressure",
       ChoiceRule{{"pressure", "traction", "force", "force per thickness", "displacement"}},
       "'pressure': against the outward normal. 'traction': force per area along the direction. "
       "'force': total force on the surface, which is rigid and moves along the direction only. "
       "'force per thickness': the same, given as a line load of a plane model. 'displacement': "
       "of the surface along the direction; across it the surface does not move."},
      {section, "Value", "", TextRule{"a value with the unit that the type asks for"},
       "Pressure and traction: a stress; force: a force; force per thickness: a force per length; "
       "displacement: a length. Negative: against the direction.",
       true},
      {section, "Direction", "", vector_of(Dimension::dimensionless, {""}),
       "Direction in x and y, in 3-D in x, y and z, of any length; not with Type = pressure, "
       "which "
       "has none."}};
}

std::vector<Parameter> geometry_file_parameters(const std::string& default_file) {
  const SectionPath section{names::geometry};
  return {
      {section, "File", default_file,
       TextRule{"the name of a .geo or .msh file in the case directory"},
       "Geometry or mesh of Gmsh. Default: geometry.geo or geometry.msh, whichever there is."},
      {section, "Length unit", "m",
       TextRule{"a unit of length, for example 'mm', 'in' or '0.1 mm'"},
       "Unit of the file's coordinates."},
      {section, "Circle tolerance", "0",
       quantity(Dimension::dimensionless, between(0., 0.01, "from 0 to 1 %")),
       "By what share of the radius the points of a curve (in 3-D: surface) may be off the "
       "circle, cylinder or sphere nearest to them; the nodes are then moved onto it. 0: what is "
       "off by more than rounding stays a polygon."},
      {section, "Plane", "plane strain",
       ChoiceRule{{"plane strain", "plane stress", "axisymmetric"}},
       "What the plane stands for. 'axisymmetric': x is the radius, y the axis of revolution. Only "
       "with Dimension = 2."},
      {section, "Thickness", "", positive(Dimension::length, {""}),
       "Thickness of a plane model; required, unless the model is axisymmetric: that has none."}};
}

QuantityRule one_for_each_pair() {
  QuantityRule rule = quantity(Dimension::dimensionless, zero_or_greater());
  rule.most = 100;
  return rule;
}

std::vector<Parameter> geometry_list_parameters() {
  const SectionPath section{names::geometry};
  return {
      {section, "Bodies", "", TextRule{"names separated by commas"},
       "Physical surfaces of the file that are bodies, in 3-D physical volumes; each has its "
       "subsection 'Body NAME'.",
       true},
      {section, "Supports", "",
       TextRule{"a list of 'surface: fixed', 'surface: x', 'surface: y' or, in 3-D, 'surface: z', "
                "separated by commas"},
       "Physical curves, in 3-D physical surfaces, that do not move at all, in x, in y, or in z; "
       "'surface: x y' holds two directions."},
      {section, "Loads", "", TextRule{"names separated by commas"},
       "Physical curves (surfaces) that are loaded; each has its subsection 'Load NAME'."},
      {section, "Contact pairs", "", TextRule{"a list of 'source -> target', separated by commas"},
       "Pairs of physical curves (surfaces) that may touch. The contact pressure is computed on "
       "the source: choose the more curved or the softer one. Without any the maximum stresses are "
       "found, to the 'Structural accuracy'."},
      {section, "Friction coefficient", "0", one_for_each_pair(),
       "Coulomb's coefficient of friction, one for all contact pairs or one for each: surfaces "
       "stick "
       "up to it and slide beyond."},
      {section, "Load steps", "", TextRule{"the name of a file in the case directory"},
       "Comma-separated file with the heading 'time [s], LOAD, LOAD' and a row of factors for each "
       "step: what the loads are multiplied with, one instant after the other, since friction "
       "remembers. 'LOAD x', 'LOAD y' and 'LOAD z' are components of a traction. Loads without a "
       "column act in full. The last step is analysed. Default: all loads at once."}};
}

/// Lengths whose squares are numbers.
QuantityRule linkage_length() {
  return quantity(Dimension::length, between(1e-9, 1e6, "from 1 nm to 1000 km"), {""});
}

std::vector<Parameter> quick_return_parameters() {
  const SectionPath section{names::synthesis};
  const std::string only = " Only with Kind = quick return.";
  const Range speed{0., 1e6, false, true, "greater than 0 and at most 1e6 rad/s"};
  return {
      {section, "Stations", "", whole_or_nothing(3, 24, "from 3 to 24"),
       "Number z of stations of the Geneva wheel that is replaced." + only},
      {section, "Maximum wheel speed", "", quantity(Dimension::angular_speed, speed, {""}),
       "Maximum angular speed of the rocker, which is that of the Geneva wheel." + only},
      {section, "Frame", "", linkage_length(),
       "Distance AD of the pivots of crank and rocker. Either the frame or the crank is given." +
           only}};
}

std::vector<Parameter> crank_rocker_parameters() {
  const SectionPath section{names::synthesis};
  const std::string only = " Only with Kind = crank-rocker.";
  const Range swing{0., loads::pi, false, false, "greater than 0 and less than 180 deg"};
  return {{section, "Swing", "", quantity(Dimension::angle, swing, {""}),
           "Angle between the extreme positions of the rocker." + only},
          {section, "Crank pivot distance", "", linkage_length(),
           "From the middle of the chord between the rocker's extreme positions to the crank's "
           "pivot, which lies on the chord produced; greater than half the chord." +
               only}};
}

std::vector<Parameter> path_parameters() {
  const SectionPath section{names::synthesis};
  const std::string only = " Only with Kind = path.";
  return {
      {section, "Points", "points.csv", TextRule{"the name of a file in the case directory"},
       "Comma-separated file with the heading 'x [mm], y [mm]', in any unit of length, and 2 to "
       "9 rows: the points that the coupler passes, in their order." +
           only},
      {section, "Starts", "3000", whole(1, 1e6, "from 1 to 1000000"),
       "How often the search starts from random dimensions: about 0.3 ms each." + only},
      {section, "Seed", "1", whole(0, 4294967295., "from 0 to 4294967295"),
       "Of the random dimensions: the same seed gives the same result." + only}};
}

/// Dimensions of a linkage, given or left to be found.
std::vector<Parameter> linkage_dimension_parameters() {
  const SectionPath section{names::synthesis};
  const QuantityRule place =
      quantity(Dimension::length, between(-1e6, 1e6, "from -1000 to 1000 km"), {""});
  const QuantityRule length = linkage_length();
  const std::string given =
      " With Kind = path as many of the nine dimensions are given as there are points fewer than "
      "nine.";
  return {{section, "Crank pivot x", "", place, "Place of the crank's pivot A." + given},
          {section, "Crank pivot y", "", place, "Place of the crank's pivot A."},
          {section, "Rocker pivot x", "", place, "Place of the rocker's pivot D."},
          {section, "Rocker pivot y", "", place, "Place of the rocker's pivot D."},
          {section, "Crank", "", length, "Crank AB. Not with Kind = crank-rocker."},
          {section, "Coupler", "", length, "Coupler BC. Only with Kind = path."},
          {section, "Rocker", "", length, "Rocker CD. Not with Kind = quick return."},
          {section, "Coupler point distance", "", length,
           "Distance BP of the coupler point from the end of the crank. Only with Kind = path."},
          {section, "Coupler point angle", "", quantity(Dimension::angle, Range(), {""}),
           "Angle from BC to BP, counter-clockwise. Only with Kind = path."}};
}

}  // namespace

SectionPath body_section(const std::string& body) { return {names::geometry, "Body " + body}; }

SectionPath load_section(const std::string& surface) {
  return {names::geometry, "Load " + surface};
}

ChoiceRule model_rule() { return {{"mechanism", "geometry", "synthesis"}}; }

std::vector<Parameter> general_parameters() {
  return {
      {{},
       "Model",
       model_rule().words.front(),
       model_rule(),
       "'mechanism': a Geneva wheel and its pin, drawn by this program (subsection "
       "Mechanism). 'geometry': a geometry of your own (subsection Geometry). 'synthesis': "
       "a linkage whose dimensions are wanted, for 'geneva synthesize' (subsection Synthesis)."},
      {{}, "Title", "", TextRule{"any text"}, "Title of the report."},
      {{}, "Project", "", TextRule{"any text"}, "Project, for the report's title block."},
      {{}, "Author", "", TextRule{"any text"}, "Who made it, for the report's title block."},
      {{},
       "Output units",
       "SI",
       ChoiceRule{{"SI", "mm-N", "in-lbf"}},
       "Units of files and tables. Values in this file carry their own units."}};
}

std::vector<Parameter> settings_parameters() {
  const Range accuracy{0., maximum_accuracy, false, true, "greater than 0 and at most 20 %"};
  return {
      {{},
       "Dimension",
       "2",
       ChoiceRule{{"2", "3"}},
       "'2': a section across the pin, the same along the whole length, or a plane geometry. '3': "
       "pin and wheel in 3-D, with bending, edges and crowning (subsection Pin), or a geometry "
       "of hexahedra."},
      {{},
       "Accuracy",
       "by dimension",
       quantity(Dimension::dimensionless, accuracy, {"by dimension"}),
       "Wanted relative error of the peak contact pressure: the mesh is refined until its "
       "estimate is smaller. 'by dimension': 0.5 % in the plane, 5 % in 3-D."},
      {{},
       "Structural accuracy",
       "by dimension",
       quantity(Dimension::dimensionless, accuracy, {"by dimension", "off"}),
       "Wanted relative error of the bodies' maximum stresses away from the contact, such as at a "
       "slot's bottom: the mesh is refined there, too, until their estimates are smaller. 'off': "
       "they are reported as the mesh for the contact has them, without contact as the coarse mesh "
       "has them. 'by dimension': 2 % in the plane and without contact, off beside a contact in "
       "3-D, where such cells are dear."},
      {{},
       "Maximum refinement levels",
       "20",
       whole(0, 28, "from 0 to 28"),
       "How often the coarse mesh may be refined."},
      {{},
       "Maximum unknowns",
       "2000000",
       whole(1, 2e9, "from 1 to 2000000000"),
       "How many displacement unknowns the finest mesh may have."},
      {{},
       "Maximum memory",
       "16 GB",
       positive(Dimension::memory),
       "How much memory all processes together, and the meshing before, may use (B, kB, MB, GB, "
       "TB, or the powers of 1024 "
       "KiB, MiB, GiB, TiB)."},
      {{},
       "Maximum time",
       "24 h",
       positive(Dimension::time),
       "How long the coarse mesh (at most 10 min) and the contact solve may take each: no mesh is "
       "begun "
       "that would end later."},
      {{},
       "Checkpoint",
       "automatic",
       ChoiceRule{{"automatic", "true", "false"}},
       "Whether every finished mesh is kept, so that 'geneva run --continue' goes on from the last "
       "one when the run was ended, or with other limits or a better accuracy. 'automatic': in "
       "3-D, from the first mesh that is finished after 60 s."},
      {{},
       "Maximum active-set steps",
       "50",
       whole(1, 10000, "from 1 to 10000"),
       "How many steps the search for the surface in contact may take on each mesh."},
      {{},
       "Linear tolerance",
       "1e-11",
       quantity(Dimension::dimensionless, between(1e-15, 1e-3, "from 1e-15 to 0.001")),
       "Where the conjugate gradients stop, relative to the load."},
      {{},
       "Linear solver",
       "automatic",
       ChoiceRule{{"automatic", "own", "ML"}},
       "Multigrid that preconditions them: Geneva's own, or smoothed aggregation of Trilinos' ML, "
       "which is slower and finds the same. 'automatic': the own one, and ML where that does not "
       "converge."}};
}

std::vector<Parameter> published_parameters() {
  const SectionPath section{names::published};
  return {{section, "Peak pressure", "", positive(Dimension::stress, {""}),
           "Peak contact pressure of a published solution, to compare with; may be left out."},
          {section, "Source", "", TextRule{"any text"}, "Where it was published."}};
}

std::vector<Parameter> allowable_parameters() {
  const SectionPath section{names::allowable};
  return {
      {section, "Contact pressure", "", positive(Dimension::stress, {""}),
       "Maximum contact pressure that is allowed; if given, the safety factor is reported, of a "
       "mechanism where it is least in the cycle."},
      {section, "Pressure times slip speed", "", positive(Dimension::pressure_times_speed, {""}),
       "Maximum product of contact pressure and slip speed that is allowed, for wear; if given, "
       "the safety factor is reported where it is least in the cycle. Of a roller: the mean "
       "pressure in its bore times the speed at which it slides there. Only with Model = "
       "mechanism."}};
}

std::vector<Parameter> mechanism_parameters() {
  std::vector<Parameter> parameters = kind_parameters();
  append(parameters, size_parameters());
  append(parameters, kind_subsections());
  append(parameters, motion_parameters());
  append(parameters, inertia_parameters());
  append(parameters, contact_model_parameters());
  append(parameters, pin_parameters());
  append(parameters, material_parameters({names::mechanism, names::pin_material}));
  append(parameters, material_parameters({names::mechanism, names::stud_material}));
  append(parameters, material_parameters({names::mechanism, names::wheel_material}));
  append(parameters, design_parameters());
  return parameters;
}

std::vector<Parameter> known_material_parameters(const std::string& name) {
  const SectionPath section{name};
  std::vector<Parameter> parameters = elastic_parameters(section);
  append(parameters,
         {{section, "Contact pressure", "", positive(Dimension::stress, {""}),
           "Peak contact pressure that the material bears for long, as far as it is known."},
          {section, "Wear coefficient", "",
           QuantityRule{Dimension::wear_coefficient, greater_than_zero(), {""}, 2, 2},
           "Worn volume over force and sliding distance, from lubricated to dry."},
          {section, "Source", "", TextRule{"where the values are from"},
           "Where the values are from.", true}});
  return parameters;
}

std::vector<Parameter> synthesis_parameters() {
  std::vector<Parameter> parameters{
      {{names::synthesis},
       "Kind",
       names::quick_return,
       ChoiceRule{{names::quick_return, names::crank_rocker, names::path}},
       "'quick return': a crank-slider-rocker that moves like an external Geneva. 'crank-rocker': "
       "its rocker swings by a given angle, in equal times forward and back. 'path': a four-bar "
       "linkage whose coupler point passes given points."}};
  append(parameters, quick_return_parameters());
  append(parameters, crank_rocker_parameters());
  append(parameters, path_parameters());
  append(parameters, linkage_dimension_parameters());
  return parameters;
}

std::vector<Parameter> geometry_parameters(const std::vector<std::string>& bodies,
                                           const std::vector<std::string>& loads,
                                           const std::string& default_file) {
  std::vector<Parameter> parameters = geometry_file_parameters(default_file);
  append(parameters, geometry_list_parameters());
  for (const std::string& body : bodies) append(parameters, body_parameters(body));
  for (const std::string& load : loads) append(parameters, load_parameters(load));
  return parameters;
}

}  // namespace geneva::model
