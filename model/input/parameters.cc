#include "model/input/parameters.h"

#include "model/input/parameter_parts.h"

namespace geneva::model {

using base::Dimension;

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
       "has them. 'by dimension': 2 % in the plane and without contact, 5 % beside a contact in "
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
       "begun that is expected to end later."},
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

std::vector<Parameter> known_material_parameters(const std::string& name) {
  const SectionPath section{name};
  std::vector<Parameter> parameters = elastic_parameters(section);
  append(parameters,
         {{section, "Contact pressure", "", positive(Dimension::stress, {""}),
           "Peak contact pressure that the material bears for long, as far as it is known."},
          {section, "Pressure by hardness", "", QuantityRule{Dimension::stress, {}, {""}, 2, 2},
           "What the contact pressure becomes with another hardness: the first value times the "
           "hardness and the second."},
          {section, "Wear coefficient", "",
           QuantityRule{Dimension::wear_coefficient, greater_than_zero(), {""}, 2, 2},
           "Worn volume over force and sliding distance, from lubricated to dry."},
          {section, "Also called", "", TextRule{"other names, separated by commas"},
           "Other names by which it is found: of other standards, of its kind."},
          {section, "Source", "", TextRule{"where the values are from"},
           "Where the values are from.", true}});
  return parameters;
}

}  // namespace geneva::model
