#include "loads/pi.h"
#include "model/input/parameter_parts.h"
#include "model/input/parameters.h"
#include "model/mechanisms/mechanism_type.h"

namespace geneva::model {

namespace {

using base::Dimension;

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
      {section, "Bore diameter", "", length,
       "Of a hollow pin that is fixed, from end to end; with Dimension = 2 for the root's stresses "
       "only. Line contacts along the pin ('geneva estimate') know it up to 0.7 of the pin's "
       "diameter. Not with Held at = core."},
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
           only_roller},
      {section, "Needles", "", whole_or_nothing(3., 200., "from 3 to 200"),
       "Number of needles between roller and stud, in one row: the load of the most loaded one and "
       "its pressure on the stud, of bore diameter less two needles, are worked out; the model is "
       "a solid pin." +
           only_roller},
      {section, "Needle diameter", "", positive(Dimension::length, {""}),
       "Diameter of the needles. Only with Needles."},
      {section, "Needle length", "", positive(Dimension::length, {""}),
       "Length of the needles that bears. Default: the wheel's thickness. Only with Needles."}};
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

}  // namespace

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

}  // namespace geneva::model
