#include "api/cad_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>
#include <utility>

#include "base/directory_replacement.h"
#include "cad/dxf_file.h"
#include "cad/step_file.h"
#include "model/mechanism_parts.h"
#include "model/naming.h"

namespace geneva {

namespace {

namespace fs = std::filesystem;
using loads::SolidPart;

/// Of what is written by closed forms and read back by way of a text.
constexpr double wanted_agreement = 1e-9;

/// Of each outline of the parts one, where it stands, under a name of its own: its layer.
std::vector<loads::Outline> layers_of(const std::vector<SolidPart>& parts, const bool is_assembly) {
  std::map<std::string, int> of_name;
  for (const SolidPart& part : parts) ++of_name[part.name];
  std::map<std::string, int> seen;
  std::vector<loads::Outline> layers;
  for (const SolidPart& part : parts) {
    const std::string number =
        of_name[part.name] > 1 ? " " + std::to_string(++seen[part.name]) : "";
    for (const loads::Extrusion& extrusion : part.extrusions) {
      loads::Outline outline =
          is_assembly ? placed(extrusion.outline, part.placement) : extrusion.outline;
      outline.name = part.name + number;
      if (part.extrusions.size() > 1) outline.name += " " + extrusion.outline.name;
      layers.push_back(std::move(outline));
    }
  }
  return layers;
}

double deviation(const double found, const double wanted) {
  return std::abs(found - wanted) / wanted;
}

CadFile checked(CadFile file) {
  if (!(file.deviation <= wanted_agreement))
    throw std::logic_error(fmt::format("{}: what was written reads back otherwise, by {:.3g}",
                                       file.name, file.deviation));
  return file;
}

CadFile write_solids(const fs::path& file, const std::vector<SolidPart>& parts,
                     const std::string& name, const cad::FileUnit unit) {
  cad::write_step(file, parts, name, unit);
  const auto solids = cad::solids_of_step(file);
  if (solids.size() != parts.size())
    throw std::logic_error(file.string() + ": solids were lost in writing");
  CadFile result{file.filename().string(), {}, 0., 0.};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    result.bodies.push_back(solids[i].name);
    result.size += solids[i].volume;
    result.deviation = std::max(result.deviation, deviation(solids[i].volume, volume(parts[i])));
  }
  return checked(std::move(result));
}

CadFile write_drawing(const fs::path& file, const std::vector<loads::Outline>& layers,
                      const cad::FileUnit unit) {
  cad::write_dxf(file, layers, unit);
  const std::map<std::string, double> areas = cad::areas_of_dxf(file, unit);
  CadFile result{file.filename().string(), {}, 0., 0.};
  for (const loads::Outline& layer : layers) {
    const auto found = areas.find(layer.name);
    if (found == areas.end())
      throw std::logic_error(file.string() + ": a layer was lost in writing");
    result.bodies.push_back(layer.name);
    result.size += found->second;
    result.deviation =
        std::max(result.deviation, deviation(found->second, loads::area_moments(layer).area));
  }
  return checked(std::move(result));
}

}  // namespace

CadExport cad_export(const Case& given, const std::optional<double> driver_angle) {
  if (!given.mechanism)
    model::refuse_model(given, "there is no Geneva mechanism to draw", "geneva export",
                        "mechanism");
  return model::naming(given, [&] {
    const model::MechanismDynamics dynamics = model::mechanism_dynamics(*given.mechanism);
    const double angle = driver_angle.value_or(
        model::analysed_angle(*given.mechanism, dynamics.driven, dynamics.train));
    auto [parts, notices] = model::mechanism_parts(*given.mechanism, angle);
    return CadExport{given, angle, std::move(parts), std::move(notices)};
  });
}

std::vector<CadFile> write(const CadExport& drawing, const fs::path& directory) {
  const cad::FileUnit unit = drawing.given.units == base::UnitSystem::inch_pound
                                 ? cad::FileUnit::inch
                                 : cad::FileUnit::millimetre;
  base::check_replaceable(directory);
  base::DirectoryReplacement replacement(directory);
  const fs::path& working = replacement.working();
  std::vector<CadFile> files;
  std::vector<std::string> done;
  for (const SolidPart& part : drawing.parts) {
    if (std::find(done.begin(), done.end(), part.name) != done.end()) continue;
    done.push_back(part.name);
    files.push_back(write_solids(working / (part.name + ".step"), {part}, part.name, unit));
    files.push_back(write_drawing(working / (part.name + ".dxf"), layers_of({part}, false), unit));
  }
  files.push_back(
      write_solids(working / "assembly.step", drawing.parts, model::name_of(drawing.given), unit));
  files.push_back(write_drawing(working / "assembly.dxf", layers_of(drawing.parts, true), unit));
  replacement.keep([](const std::string&) { return true; });
  replacement.commit();
  return files;
}

}  // namespace geneva
