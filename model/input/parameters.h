#pragma once

#include <string>
#include <vector>

#include "model/input/parameter_rule.h"
#include "model/input/parameter_text.h"

namespace geneva::model {

/// A parameter of the case file.
struct Parameter {
  SectionPath section;
  std::string name;
  std::string default_value;
  Rule rule;
  std::string help;
  bool required = false;  ///< has to be given: its empty default stands for nothing
};

/// The one place where the names and words of the case file are spelt.
namespace names {
inline constexpr const char* mechanism = "Mechanism";
inline constexpr const char* geometry = "Geometry";
inline constexpr const char* synthesis = "Synthesis";
inline constexpr const char* published = "Published";
inline constexpr const char* allowable = "Allowable";
inline constexpr const char* pin_material = "Pin material";
inline constexpr const char* stud_material = "Stud material";
inline constexpr const char* wheel_material = "Wheel material";
inline constexpr const char* material = "Material";
inline constexpr const char* optimisation = "Optimisation";
inline constexpr const char* peak_pressure = "peak contact pressure";
inline constexpr const char* peak_pressure_of_cycle = "peak contact pressure of the cycle";
inline constexpr const char* wheel_mass = "mass of the wheel";
inline constexpr const char* slot_bottom = "stress at the slot bottom";
inline constexpr const char* design = "Design";
inline constexpr const char* shaft = "Shaft";
inline constexpr const char* fixed = "fixed";
inline constexpr const char* roller = "roller";
inline constexpr const char* default_word = "default";
inline constexpr const char* at_maximum_acceleration = "at maximum wheel acceleration";
inline constexpr const char* at_maximum_force = "at maximum pin force";
inline constexpr const char* from_geometry = "from geometry";
inline constexpr const char* johnson = "Johnson";
inline constexpr const char* linkage = "Linkage";
inline constexpr const char* constant = "constant";
inline constexpr const char* table = "table";
inline constexpr const char* cycloidal_carrier = "cycloidal on the carrier";
inline constexpr const char* harmonic_carrier = "harmonic on the carrier";
inline constexpr const char* cycloidal_cross = "cycloidal on the cross";
inline constexpr const char* harmonic_cross = "harmonic on the cross";
inline constexpr const char* full_wheel = "full wheel";
inline constexpr const char* local = "local";
inline constexpr const char* solid_cylinder = "solid cylinder";
inline constexpr const char* scale_with_the_wheel = "scale with the wheel";
inline constexpr const char* quick_return = "quick return";
inline constexpr const char* crank_rocker = "crank-rocker";
inline constexpr const char* path = "path";
inline constexpr const char* pin = "Pin";
inline constexpr const char* one_end = "one end";
inline constexpr const char* both_ends = "both ends";
inline constexpr const char* core = "core";
inline constexpr const char* cylindrical = "cylindrical";
inline constexpr const char* crown = "crown";
inline constexpr const char* logarithmic = "logarithmic";
inline constexpr const char* sharp = "sharp";
inline constexpr const char* chamfered = "chamfered";
inline constexpr const char* rounded = "rounded";
inline constexpr const char* stay_as_given = "stay as given";
}  // namespace names

/// Section of a body's material or of a load: "Body NAME", "Load NAME" in Geometry.
SectionPath body_section(const std::string& body);
SectionPath load_section(const std::string& surface);

/// What every case has: model, title, units.
std::vector<Parameter> general_parameters();

/// The coarsest relative error of the peak contact pressure that may be asked for.
constexpr double maximum_accuracy = 0.2;

/// Accuracy and limits of a solution, which Model = mechanism and Model = geometry have besides.
std::vector<Parameter> settings_parameters();

/// Published values to compare with, which the same cases may have.
std::vector<Parameter> published_parameters();
/// What the same cases may allow, for safety factors.
std::vector<Parameter> allowable_parameters();

/// What a case with Model = mechanism has besides.
std::vector<Parameter> mechanism_parameters();

/// What it says of its file.
std::vector<Parameter> geometry_file_parameters(const std::vector<std::string>& picks,
                                                const std::string& default_file);

/// What a case with Model = geometry has besides.
/// @param picks names of parameters that name places of a STEP file
/// @param default_file name of the geometry's file if the case does not give it
std::vector<Parameter> geometry_parameters(const std::vector<std::string>& bodies,
                                           const std::vector<std::string>& loads,
                                           const std::vector<std::string>& picks,
                                           const std::string& default_file);

/// Elastic constants, density and strengths of a material of the collection, and what it allows.
std::vector<Parameter> known_material_parameters(const std::string& name);

/// What a case with Model = synthesis has besides.
std::vector<Parameter> synthesis_parameters();

/// Allowed values of the parameter that chooses the model; its first word is the default.
ChoiceRule model_rule();

}  // namespace geneva::model
