#include "app/export.h"

#include <fmt/format.h>

#include <iostream>
#include <optional>

#include "api/cad_export.h"
#include "app/commands.h"
#include "app/highlight.h"
#include "base/units.h"

namespace geneva::app {

namespace fs = std::filesystem;

namespace {

std::optional<double> angle_of(const std::string& text) {
  if (text.empty()) return std::nullopt;
  try {
    return base::parse_quantity(text, base::Dimension::angle);
  } catch (const base::InputError& error) {
    throw base::InputError(fmt::format("--angle: {}", error.what()));
  }
}

/// What a file holds: a volume, of a drawing an area.
std::string size_of(const CadFile& file, const base::UnitSystem units) {
  const base::OutputUnit length = base::output_unit(units, base::Dimension::length);
  const bool is_drawing = fs::path(file.name).extension() == ".dxf";
  const double factor = length.factor * length.factor * (is_drawing ? 1. : length.factor);
  return fmt::format("{:.6g} {}^{}", file.size * factor, length.name, is_drawing ? 2 : 3);
}

}  // namespace

int export_case(const fs::path& case_directory, const fs::path& output, const std::string& angle) {
  const CadExport drawing = cad_export(read_case(case_directory), angle_of(angle));
  const fs::path directory = output.empty() ? drawing.given.directory / "cad" : output;
  const std::vector<CadFile> files = write(drawing, directory);
  const base::OutputUnit degrees = base::output_unit(drawing.given.units, base::Dimension::angle);
  std::cout << fmt::format("{}, assembly at driver angle {:.6g} {}\n",
                           model::name_of(drawing.given), drawing.driver_angle * degrees.factor,
                           degrees.name);
  for (const CadFile& file : files)
    std::cout << fmt::format("{:<16}{:>22}   read back within {:.1g}   {}\n", file.name,
                             size_of(file, drawing.given.units), file.deviation,
                             fmt::join(file.bodies, ", "));
  for (const std::string& notice : drawing.notices)
    std::cout << for_stream("note: " + notice, stdout) << '\n';
  std::cout << "drawings in " << shown_path(directory) << '\n';
  return 0;
}

}  // namespace geneva::app
