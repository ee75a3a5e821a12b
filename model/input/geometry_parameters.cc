#include "model/input/parameter_parts.h"
#include "model/input/parameters.h"

namespace geneva::model {

namespace {

using base::Dimension;

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
      {section, "Contact pairs", "",
       TextRule{"a list of 'surface -> surface', separated by commas"},
       "Pairs of physical curves (surfaces) that may touch. The contact pressure is computed at "
       "the nodes of the softer body's surface, of equally stiff ones at the first one's. Without "
       "any the maximum stresses are found, to the 'Structural accuracy'."},
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

Parameter pick_parameter(const std::string& name) {
  return {{names::geometry},
          name,
          "",
          TextRule{"'face nearest X, Y, Z', lengths with their units; of a body 'solid nearest', "
                   "with Dimension = 2 'edge nearest X, Y' and of a body 'face nearest'"},
          "Name for what is nearest to a place in a STEP file."};
}

}  // namespace

std::vector<Parameter> geometry_file_parameters(const std::vector<std::string>& picks,
                                                const std::string& default_file) {
  const SectionPath section{names::geometry};
  std::vector<Parameter> parameters{
      {section, "File", default_file,
       TextRule{"the name of a .geo, .msh, .step or .stp file in the case directory"},
       "Geometry or mesh of Gmsh, or parts of a CAD system. Default: geometry.geo or geometry.msh, "
       "whichever there is. In a STEP file bodies go by the names of products, surfaces by those "
       "of "
       "faces; 'set Surface NAME = nearest X, Y, Z' names the face (with Dimension = 2: edge) that "
       "is nearest to a place, 'set Solid NAME = nearest X, Y, Z' a body."},
      {section, "Length unit", "m",
       TextRule{"a unit of length, for example 'mm', 'in' or '0.1 mm'"},
       "Unit of the file's coordinates; a STEP file has its own."},
      {section, "Cell size", "", positive(Dimension::length, {""}),
       "Of the coarse cells of a STEP file, which are refined while solving. Default: a sixth of "
       "the mean extent of each body, finer where it is curved."},
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
  for (const std::string& pick : picks) parameters.push_back(pick_parameter(pick));
  return parameters;
}

std::vector<Parameter> geometry_parameters(const std::vector<std::string>& bodies,
                                           const std::vector<std::string>& loads,
                                           const std::vector<std::string>& picks,
                                           const std::string& default_file) {
  std::vector<Parameter> parameters = geometry_file_parameters(picks, default_file);
  append(parameters, geometry_list_parameters());
  for (const std::string& body : bodies) append(parameters, body_parameters(body));
  for (const std::string& load : loads) append(parameters, load_parameters(load));
  return parameters;
}

}  // namespace geneva::model
