#include "model/input/parameter_parts.h"

#include <utility>

namespace geneva::model {

using base::Dimension;

/// May be left empty.
QuantityRule whole_or_nothing(const double lower, const double upper, const std::string& text) {
  QuantityRule rule = whole(lower, upper, text);
  rule.words = {""};
  return rule;
}

void append(std::vector<Parameter>& parameters, std::vector<Parameter> more) {
  for (Parameter& parameter : more) parameters.push_back(std::move(parameter));
}

/// Of a case or of the collection.
std::vector<Parameter> elastic_parameters(const SectionPath& section) {
  const Range hardness{20., 1500., true, true, "from 20 to 1500"};
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
       "maximum tensile stress away from the contact is reported."},
      {section, "Hardness", "", quantity(Dimension::dimensionless, hardness, {""}),
       "Vickers (or Brinell) number of the surface: what gears of this hardness bear where the "
       "material is one whose endurance follows from it, and a third of it (Tabor) as the yield "
       "strength of a hardened layer."},
      {section, "Hardened depth", "", positive(Dimension::length, {""}),
       "Depth of a case-hardened, nitrided or induction-hardened layer: contact limits are those "
       "of the layer down to this depth and of 'Yield strength', the core's, below it. Left out: "
       "one strength throughout."}};
}

/// Of a case: by name, by value, or both.
std::vector<Parameter> material_parameters(const SectionPath& section) {
  std::vector<Parameter> parameters{
      {section, names::material, "", TextRule{"a name of 'geneva materials', or nothing"},
       "Material whose typical values stand for those that are not given here: elastic constants, "
       "density, yield and fatigue strength, and the contact pressure that it allows."}};
  append(parameters, elastic_parameters(section));
  parameters.push_back(
      {section, "Contact pressure", "", positive(Dimension::stress, {""}),
       "Peak contact pressure that the material bears for long, without pits; if known, the safety "
       "factor against it is reported. Left out: that of the named material, with another "
       "'Hardness' the one that belongs to it."});
  return parameters;
}

}  // namespace geneva::model
