#include "post/output/contact_output.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "base/output_file.h"
#include "post/analysis/partial_slip_form.h"
#include "post/analysis/sliding_surface.h"
#include "post/output/result_files.h"

namespace geneva::post {

using base::Dimension;
using base::output_unit;
using base::OutputUnit;
using base::UnitSystem;

namespace fs = std::filesystem;

namespace {

/// One column of the contact files.
struct ContactColumn {
  std::string name;
  std::string unit;
  std::vector<double> values;
};

/// Open, in contact; with friction open, sticking, slipping.
double status_number(const fem::NodeStatus status, const bool has_friction) {
  if (!is_closed(status)) return 0.;
  return has_friction && status == fem::NodeStatus::slip ? 2. : 1.;
}

/// Traction on the source, and slip where it is not imposed.
template <int dim>
void add_friction_columns(const fem::ContactResult<dim>& contact, const UnitSystem units,
                          std::vector<ContactColumn>& columns) {
  const OutputUnit length = output_unit(units, Dimension::length);
  const OutputUnit stress = output_unit(units, Dimension::stress);
  const std::array<const char*, 3> axes{"x", "y", "z"};
  for (std::size_t i = 0; i < dim; ++i) {
    columns.push_back({std::string("friction_") + axes[i], stress.name, {}});
    for (const fem::ContactNode<dim>& node : contact.nodes)
      columns.back().values.push_back(node.friction[i] * stress.factor);
  }
  for (std::size_t i = 0; i < dim; ++i) {
    columns.push_back({std::string("slip_") + axes[i], length.name, {}});
    for (const fem::ContactNode<dim>& node : contact.nodes)
      columns.back().values.push_back(node.slip[i] * length.factor);
  }
}

/// Friction along the direction in which the pair is moved, by Cattaneo and Mindlin.
template <int dim>
ContactColumn mindlin_column(const fem::ContactResult<dim>& contact,
                             const ContactAnalysis<dim>& analysis,
                             const std::optional<PartialSlipForm<dim>>& mindlin,
                             const UnitSystem units) {
  const OutputUnit stress = output_unit(units, Dimension::stress);
  ContactColumn column{"mindlin_friction", stress.name, {}};
  for (const fem::ContactNode<dim>& node : contact.nodes)
    column.values.push_back(mindlin ? mindlin->traction(analysis, node) * stress.factor
                                    : std::numeric_limits<double>::quiet_NaN());
  return column;
}

/// Stress along both surfaces, of plane strain and plane stress.
void add_surface_columns(const fem::Solution<2>& solution, const fem::ContactResult<2>& contact,
                         const UnitSystem units, std::vector<ContactColumn>& columns) {
  const OutputUnit stress = output_unit(units, Dimension::stress);
  const std::vector<SurfaceStress> stresses = surface_stresses(solution, contact);
  if (stresses.empty()) return;
  ContactColumn source{"surface_stress_source", stress.name, {}};
  ContactColumn target{"surface_stress_target", stress.name, {}};
  for (const SurfaceStress& at : stresses) {
    source.values.push_back(at.source * stress.factor);
    target.values.push_back(at.target * stress.factor);
  }
  columns.insert(columns.end(), {source, target});
}

/// Of the whole pin, by line contacts along it, at the nodes.
ContactColumn line_load_column(const fem::ContactResult<3>& contact,
                               const loads::PinLineContact& line, const UnitSystem units) {
  const OutputUnit line_load = output_unit(units, Dimension::force_per_length);
  ContactColumn column{"line_load_half_space_and_beam", line_load.name, {}};
  for (const fem::ContactNode<3>& node : contact.nodes)
    column.values.push_back(loads::line_load_at(line, node.position[2]) * line_load.factor);
  return column;
}

/// Of one pair of a solution.
template <int dim>
std::vector<ContactColumn> contact_columns(const fem::Solution<dim>& solution,
                                           const Results<dim>& results, const std::size_t pair,
                                           const std::optional<PinLineReport>& line,
                                           const UnitSystem units) {
  const fem::ContactResult<dim>& contact = solution.contacts[pair];
  const ContactAnalysis<dim>& analysis = results.contacts[pair];
  const bool has_friction = fem::has_friction(solution.problem);
  const OutputUnit length = output_unit(units, Dimension::length);
  const OutputUnit stress = output_unit(units, Dimension::stress);
  std::vector<ContactColumn> columns;
  if (dim == 2) columns.push_back({"arc_length", length.name, {}});
  for (const char* axis : {"x", "y", "z"})
    if (columns.size() < 3) columns.push_back({axis, length.name, {}});
  columns.insert(columns.end(), {{"contact_pressure", stress.name, {}},
                                 {"gap", length.name, {}},
                                 {"status", "", {}},
                                 {"hertz_pressure", stress.name, {}}});
  for (const fem::ContactNode<dim>& node : contact.nodes) {
    std::vector<double> row;
    if (dim == 2) row.push_back(node.arc_length * length.factor);
    for (const double component : node.position) row.push_back(component * length.factor);
    row.insert(row.end(), {node.pressure * stress.factor, node.gap * length.factor,
                           status_number(node.status, has_friction),
                           hertz_pressure(analysis, node) * stress.factor});
    for (std::size_t i = 0; i < row.size(); ++i) columns[i].values.push_back(row[i]);
  }
  if constexpr (dim == 3)
    if (line) columns.push_back(line_load_column(contact, line->contact, units));
  if (!has_friction) return columns;
  add_friction_columns(contact, units, columns);
  columns.push_back(
      mindlin_column(contact, analysis, partial_slip(solution, pair, analysis), units));
  if constexpr (dim == 2) add_surface_columns(solution, contact, units, columns);
  return columns;
}

std::vector<ContactColumn> section_columns(const ContactAnalysis<3>& analysis,
                                           const std::optional<PinLineReport>& line,
                                           const UnitSystem units) {
  const OutputUnit length = output_unit(units, Dimension::length);
  const OutputUnit stress = output_unit(units, Dimension::stress);
  const OutputUnit line_load = output_unit(units, Dimension::force_per_length);
  std::vector<ContactColumn> columns{{"z", length.name, {}},
                                     {"line_load", line_load.name, {}},
                                     {"peak_pressure", stress.name, {}},
                                     {"half_width", length.name, {}},
                                     {"max_shear", stress.name, {}},
                                     {"max_shear_depth", length.name, {}}};
  if (line) columns.push_back({"line_load_half_space_and_beam", line_load.name, {}});
  for (const ContactSection& section : analysis.sections) {
    const std::array<double, 6> row{section.z * length.factor,
                                    section.line_load * line_load.factor,
                                    section.peak_pressure * stress.factor,
                                    section.half_width * length.factor,
                                    section.max_shear * stress.factor,
                                    section.max_shear_depth * length.factor};
    for (std::size_t i = 0; i < row.size(); ++i) columns[i].values.push_back(row[i]);
    if (line)
      columns.back().values.push_back(loads::line_load_at(line->contact, section.z) *
                                      line_load.factor);
  }
  return columns;
}

std::vector<ContactColumn> depth_columns(const ContactAnalysis<2>& analysis,
                                         const UnitSystem units) {
  const OutputUnit length = output_unit(units, Dimension::length);
  const OutputUnit stress = output_unit(units, Dimension::stress);
  std::vector<ContactColumn> columns{{"depth", length.name, {}}};
  for (const char* const prefix : {"", "mcewen_"})
    for (const char* const name :
         {"stress_along", "stress_across", "stress_out_of_plane", "maximum_shear"})
      columns.push_back({std::string(prefix) + name, stress.name, {}});
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (const DepthSample& sample : analysis.depth_line) {
    const ContactStress& computed = sample.computed;
    const ContactStress exact = sample.closed_form.value_or(ContactStress{none, none, none, none});
    const std::array<double, 8> stresses{computed.along,     computed.across, computed.out_of_plane,
                                         computed.shear,     exact.along,     exact.across,
                                         exact.out_of_plane, exact.shear};
    columns[0].values.push_back(sample.depth * length.factor);
    for (std::size_t i = 0; i < stresses.size(); ++i)
      columns[i + 1].values.push_back(stresses[i] * stress.factor);
  }
  return columns;
}

/// A table with one block of rows for each contact pair.
template <int dim, typename ColumnsOf>
void write_csv(const fem::Solution<dim>& solution, const ColumnsOf& columns_of,
               const fs::path& file) {
  std::ofstream stream = base::open_output(file);
  for (std::size_t pair = 0; pair < solution.contacts.size(); ++pair) {
    const std::vector<ContactColumn> columns = columns_of(pair);
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
  base::close_output(stream, file);
}

/// What a pair carries at each load step.
template <int dim>
std::vector<ContactColumn> step_columns(const fem::Solution<dim>& solution, const std::size_t pair,
                                        const UnitSystem units) {
  const OutputUnit force = output_unit(units, Dimension::force);
  const std::array<const char*, 3> axes{"x", "y", "z"};
  std::vector<ContactColumn> columns{{"step", "", {}}, {"time", "s", {}}};
  for (const char* const name : {"force_", "friction_force_"})
    for (std::size_t i = 0; i < dim; ++i)
      columns.push_back({std::string(name) + axes[i], force.name, {}});
  columns.insert(columns.end(), {{"dissipated", "J", {}},
                                 {"sticking_nodes", "", {}},
                                 {"slipping_nodes", "", {}},
                                 {"work", "J", {}},
                                 {"elastic_energy", "J", {}}});
  for (std::size_t step = 0; step < solution.instants.size(); ++step) {
    const fem::PairAtInstant<dim>& at = solution.instants[step].pairs[pair];
    std::vector<double> row{static_cast<double>(step + 1), solution.problem.steps[step].time};
    for (const double component : at.force) row.push_back(component * force.factor);
    for (const double component : at.friction_force) row.push_back(component * force.factor);
    row.insert(row.end(),
               {at.dissipated, static_cast<double>(at.sticking), static_cast<double>(at.slipping),
                solution.instants[step].energy.work, solution.instants[step].energy.stored});
    for (std::size_t i = 0; i < row.size(); ++i) columns[i].values.push_back(row[i]);
  }
  return columns;
}

/// Cells of a VTK unstructured grid as text.
struct VtkCells {
  std::string connectivity;
  std::string offsets;
  std::string types;
  std::size_t count = 0;
  std::size_t n_corners = 0;

  template <typename Corners>
  void add(const Corners& corners, const std::size_t first_point, const int type) {
    for (const std::size_t corner : corners) {
      connectivity += fmt::format("{} ", first_point + corner);
      ++n_corners;
    }
    connectivity += '\n';
    offsets += fmt::format("{}\n", n_corners);
    types += fmt::format("{}\n", type);
    ++count;
  }
};

/// Lines from node to node in the plane, quadrilaterals in 3-D.
void add_cells(const fem::ContactResult<2>& contact, const std::size_t first_point,
               VtkCells& cells) {
  constexpr int line = 3;
  for (std::size_t i = 0; i + 1 < contact.nodes.size(); ++i)
    cells.add(std::array<std::size_t, 2>{i, i + 1}, first_point, line);
}
void add_cells(const fem::ContactResult<3>& contact, const std::size_t first_point,
               VtkCells& cells) {
  constexpr int quadrilateral = 9;
  for (const auto& face : contact.faces) cells.add(face, first_point, quadrilateral);
}

/// The source surfaces with what they carry, as a VTK unstructured grid.
template <int dim>
void write_contact_vtu(const fem::Solution<dim>& solution, const Results<dim>& results,
                       const std::optional<PinLineReport>& line, const UnitSystem units,
                       const fs::path& file) {
  std::string points;
  VtkCells cells;
  std::vector<ContactColumn> all;
  std::size_t n_points = 0;
  for (std::size_t pair = 0; pair < solution.contacts.size(); ++pair) {
    const auto columns = contact_columns(solution, results, pair, line, units);
    if (all.empty()) all.assign(columns.begin(), columns.end());
    if (pair > 0)
      for (std::size_t i = 0; i < columns.size(); ++i)
        all[i].values.insert(all[i].values.end(), columns[i].values.begin(),
                             columns[i].values.end());
    const std::size_t rows = columns.front().values.size();
    for (std::size_t row = 0; row < rows; ++row)
      if (dim == 2)
        points += fmt::format("{:.9g} {:.9g} 0\n", columns[1].values[row], columns[2].values[row]);
      else
        points += fmt::format("{:.9g} {:.9g} {:.9g}\n", columns[0].values[row],
                              columns[1].values[row], columns[2].values[row]);
    add_cells(solution.contacts[pair], n_points, cells);
    n_points += rows;
  }
  std::ofstream stream = base::open_output(file);
  stream << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
            "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"
         << fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<PointData>\n",
                        n_points, cells.count);
  for (const ContactColumn& column : all) {
    if (column.name == "x" || column.name == "y" || column.name == "z") continue;
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
         << cells.connectivity
         << "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n"
         << cells.offsets
         << "</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n"
         << cells.types << "</DataArray>\n</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  base::close_output(stream, file);
}

}  // namespace

template <int dim>
void write_contact(const fem::Solution<dim>& solution, const Results<dim>& results,
                   const std::optional<PinLineReport>& line, const UnitSystem units,
                   const fs::path& directory) {
  write_csv(
      solution,
      [&](const std::size_t pair) { return contact_columns(solution, results, pair, line, units); },
      own_file(directory, "contact.csv"));
  write_contact_vtu(solution, results, line, units, own_file(directory, "contact.vtu"));
  if (!solution.problem.steps.empty())
    write_csv(
        solution, [&](const std::size_t pair) { return step_columns(solution, pair, units); },
        own_file(directory, "steps.csv"));
  write_csv(
      solution,
      [&](const std::size_t pair) {
        if constexpr (dim == 3)
          return section_columns(results.contacts[pair], line, units);
        else
          return depth_columns(results.contacts[pair], units);
      },
      own_file(directory, dim == 3 ? "sections.csv" : "depth.csv"));
}

template void write_contact(const fem::Solution<2>&, const Results<2>&,
                            const std::optional<PinLineReport>&, UnitSystem, const fs::path&);
template void write_contact(const fem::Solution<3>&, const Results<3>&,
                            const std::optional<PinLineReport>&, UnitSystem, const fs::path&);

}  // namespace geneva::post
