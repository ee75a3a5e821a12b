#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/input/parameter_text.h"
#include "model/input/parameters.h"

namespace geneva::model {

/// A material of the collection; SI units.
struct KnownMaterial {
  std::string name;
  std::string also_called;                   ///< other names, divided by commas
  std::map<std::string, std::string> texts;  ///< by parameter of a case's material, as written
  double youngs_modulus;                     ///< [Pa]
  double poissons_ratio;
  double density;                                                 ///< [kg/m^3]
  std::optional<double> yield_strength;                           ///< [Pa]
  std::optional<double> fatigue_strength;                         ///< pulsating [Pa]
  std::optional<double> contact_pressure;                         ///< that it bears for long [Pa]
  std::optional<double> hardness;                                 ///< Vickers or Brinell number
  std::optional<std::pair<double, double>> pressure_by_hardness;  ///< slope and offset [Pa]
  std::optional<std::pair<double, double>> wear;  ///< coefficient, lubricated and dry [m^2/N]
  std::string source;                             ///< of each value, divided by semicolons
};

/// What the flanks of gears of the material bear, by a hardness other than the material's own where
/// one is given and the endurance follows from it; nothing of a softer one where it does not.
std::optional<double> flank_pressure(const KnownMaterial& material,
                                     const std::optional<double>& hardness);

/// The file of materials that the program brings.
extern const std::string_view materials_file;

/// Materials that the program brings, then those of the user's configuration directory, then those
/// of materials.prm in the case directory; a later one takes the place of another of its name.
/// @param case_directory empty: none
/// @throws base::InputError with file and line for what a file of materials cannot say
std::vector<KnownMaterial> known_materials(const std::filesystem::path& case_directory);

/// The material of that name, without regard to case.
/// @throws base::InputError naming those that contain the name, or the nearest
const KnownMaterial& material_named(const std::vector<KnownMaterial>& materials,
                                    const std::string& name);

/// Makes the values of the materials that the text names the defaults of their subsections.
/// @return the materials, by subsection
/// @throws base::InputError with file, line and the nearest name for one that is not known
std::map<SectionPath, KnownMaterial> take_materials(std::vector<Parameter>& parameters,
                                                    const ParameterText& text,
                                                    const std::filesystem::path& case_directory);

}  // namespace geneva::model
