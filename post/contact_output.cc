#include "post/contact_output.h"

#include <fmt/format.h>

#include <cmath>

#include "post/output_file.h"

namespace geneva::post {

namespace fs = std::filesystem;

namespace {

/// One column of the contact files.
struct ContactColumn {
  std::string name;
  std::string unit;
  std::vector<double> values;
};

std::vector<ContactColumn> contact_columns(const fem::ContactResult<2>& contact,
                                           const ContactAnalysis& analysis,
                                           const UnitSystem units) {
  const OutputUnit length = output_unit(units, Dimension::length);
  const OutputUnit stress = output_unit(units, Dimension::stress);
  std::vector<ContactColumn> columns{
      {"arc_length", length.name, {}},       {"x", length.name, {}},   {"y", length.name, {}},
      {"contact_pressure", stress.name, {}}, {"gap", length.name, {}}, {"status", "", {}},
      {"hertz_pressure", stress.name, {}}};
  for (const fem::ContactNode<2>& node : contact.nodes) {
    const double hertz = analysis.hertz ? analysis.hertz->pressure(node.arc_length) : std::nan("");
    const std::array<double, 7> row{node.arc_length * length.factor,
                                    node.position[0] * length.factor,
                                    node.position[1] * length.factor,
                                    node.pressure * stress.factor,
                                    node.gap * length.factor,
                                    node.active ? 1. : 0.,
                                    hertz * stress.factor};
    for (std::size_t i = 0; i < row.size(); ++i) columns[i].values.push_back(row[i]);
  }
  return columns;
}

void write_contact_csv(const fem::Solution<2>& solution, const Results& results,
                       const UnitSystem units, const fs::path& file) {
  std::ofstream stream = open_output(file);
  for (std::size_t pair = 0; pair < solution.contacts.size(); ++pair) {
    const auto columns = contact_columns(solution.contacts[pair], results.contacts[pair], units);
    if (pair == 0) {
      stream << "pair";
      for (const ContactColumn& column : columns)
        stream << ',' << column.name << (column.unit.empty() ? "" : " [" + column.unit + "]");
      stream << '\n';
    }
    for (std::size_t row = 0; row < columns.front().values.size(); ++row) {
      stream << fmt::format("{} -> {}", solution.contacts[pair].source,
                            solution.contacts[pair].target);
      for (const ContactColumn& column : columns)
        stream << (std::isnan(column.values[row]) ? ","
                                                  : fmt::format(",{:.12g}", column.values[row]));
      stream << '\n';
    }
  }
  close_output(stream, file);
}

/// Contact nodes joined by lines along each source surface, as a VTK unstructured grid.
void write_contact_vtu(const fem::Solution<2>& solution, const Results& results,
                       const UnitSystem units, const fs::path& file) {
  std::string points;
  std::string connectivity;
  std::string offsets;
  std::string types;
  std::vector<ContactColumn> all;
  std::size_t n_points = 0;
  std::size_t n_cells = 0;
  for (std::size_t pair = 0; pair < solution.contacts.size(); ++pair) {
    const auto columns = contact_columns(solution.contacts[pair], results.contacts[pair], units);
    if (all.empty()) all.assign(columns.begin(), columns.end());
    if (pair > 0)
      for (std::size_t i = 0; i < columns.size(); ++i)
        all[i].values.insert(all[i].values.end(), columns[i].values.begin(),
                             columns[i].values.end());
    const std::size_t rows = columns.front().values.size();
    for (std::size_t row = 0; row < rows; ++row) {
      points += fmt::format("{:.9g} {:.9g} 0\n", columns[1].values[row], columns[2].values[row]);
      if (row + 1 == rows) continue;
      connectivity += fmt::format("{} {}\n", n_points + row, n_points + row + 1);
      offsets += fmt::format("{}\n", 2 * (++n_cells));
      types += "3\n";
    }
    n_points += rows;
  }
  std::ofstream stream = open_output(file);
  stream << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
            "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"
         << fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<PointData>\n",
                        n_points, n_cells);
  for (const ContactColumn& column : all) {
    if (column.name == "x" || column.name == "y") continue;
    stream << fmt::format("<DataArray type=\"Float64\" Name=\"{}\" format=\"ascii\">\n",
                          column.name);
    for (const double value : column.values) stream << fmt::format("{:.12g}\n", value);
    if (!column.unit.empty())  // after the values: readers take the text from the opening tag on
      stream << fmt::format(
          "<InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">{}</InformationKey>\n",
          column.unit);
    stream << "</DataArray>\n";
  }
  stream << "</PointData>\n<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" "
            "format=\"ascii\">\n"
         << points << "</DataArray>\n</Points>\n<Cells>\n"
         << "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n"
         << connectivity
         << "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n"
         << offsets << "</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n"
         << types << "</DataArray>\n</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  close_output(stream, file);
}

}  // namespace

void write_contact(const fem::Solution<2>& solution, const Results& results, const UnitSystem units,
                   const fs::path& directory) {
  write_contact_csv(solution, results, units, directory / "contact.csv");
  write_contact_vtu(solution, results, units, directory / "contact.vtu");
}

}  // namespace geneva::post
