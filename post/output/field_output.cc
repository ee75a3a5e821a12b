#include "post/output/field_output.h"

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>
#include <deal.II/grid/reference_cell.h>
#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/data_postprocessor.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>

#include "base/output_file.h"
#include "fem/discretisation/round_cell.h"
#include "post/output/hdf5_image.h"
#include "post/output/result_files.h"

namespace geneva::post {

using base::Dimension;
using base::output_unit;
using base::UnitSystem;

using dealii::Point;
namespace fs = std::filesystem;

namespace {

using Interpretation = dealii::DataComponentInterpretation::DataComponentInterpretation;
using NonscalarRanges =
    std::vector<std::tuple<unsigned int, unsigned int, std::string, Interpretation>>;
constexpr Interpretation scalar = dealii::DataComponentInterpretation::component_is_scalar;
constexpr Interpretation tensor_part =
    dealii::DataComponentInterpretation::component_is_part_of_tensor;

/// DataOut in the units of the output instead of those of the triangulation.
template <int dim>
class ScaledDataOut : public dealii::DataOut<dim> {
 public:
  void scale_positions(const double factor) {
    for (auto& patch : this->patches)
      for (auto& vertex : patch.vertices) vertex *= factor;
  }

  /// All arrays one after the other at a place of a round cell, from what is interpolated between
  /// the cell's corners.
  using ValuesAt = std::function<std::vector<double>(
      const typename dealii::DoFHandler<dim>::active_cell_iterator&, const Point<dim>& place,
      const std::vector<double>& interpolated)>;

  /// Divides the patches of round cells, so that round surfaces are shown round.
  void round(const dealii::DoFHandler<dim>& dof_handler, const ValuesAt& values_at) {
    std::vector<Patch> divided;
    auto patch = this->patches.begin();
    for (const auto& cell : dof_handler.active_cell_iterators()) {
      if (!cell->is_locally_owned()) continue;
      const fem::RoundCell<dim> round(cell);
      if (round.is_round())
        add_parts(
            *patch, round,
            [&](const Point<dim>& place, const std::vector<double>& interpolated) {
              return values_at(cell, place, interpolated);
            },
            divided);
      else
        divided.push_back(std::move(*patch));
      ++patch;
    }
    this->patches = std::move(divided);
    for (unsigned int i = 0; i < this->patches.size(); ++i) this->patches[i].patch_index = i;
  }

  /// From now on each component of a tensor is an array of its own: HDF5 output knows no plane
  /// tensors and would keep only some of their components.
  void take_tensors_apart() { tensors_apart_ = true; }

 protected:
  [[nodiscard]] std::vector<std::string> get_dataset_names() const override {
    std::vector<std::string> names = dealii::DataOut<dim>::get_dataset_names();
    if (!tensors_apart_) return names;
    const std::string axes = "xyz";
    for (const auto& range : dealii::DataOut<dim>::get_nonscalar_data_ranges())
      if (std::get<3>(range) == tensor_part)
        for (unsigned int i = 0; i < dim * dim; ++i)
          names[std::get<0>(range) + i] += std::string("_") + axes[i / dim] + axes[i % dim];
    return names;
  }

  [[nodiscard]] NonscalarRanges get_nonscalar_data_ranges() const override {
    NonscalarRanges ranges = dealii::DataOut<dim>::get_nonscalar_data_ranges();
    if (tensors_apart_)
      ranges.erase(
          std::remove_if(ranges.begin(), ranges.end(),
                         [](const auto& range) { return std::get<3>(range) == tensor_part; }),
          ranges.end());
    return ranges;
  }

 private:
  using Patch = dealii::DataOutBase::Patch<dim>;
  using InCell = std::function<std::vector<double>(const Point<dim>&, const std::vector<double>&)>;
  static constexpr unsigned int n_corners = dealii::GeometryInfo<dim>::vertices_per_cell;

  static void add_parts(const Patch& whole, const fem::RoundCell<dim>& round,
                        const InCell& values_at, std::vector<Patch>& parts) {
    for (const fem::PartCorner& first : round.first_corners())
      parts.push_back(part(whole, round, first, values_at));
  }

  static Patch part(const Patch& whole, const fem::RoundCell<dim>& round,
                    const fem::PartCorner& first, const InCell& values_at) {
    Patch result = whole;
    std::fill(std::begin(result.neighbors), std::end(result.neighbors), Patch::no_neighbor);
    for (unsigned int corner = 0; corner < n_corners; ++corner) {
      const Point<dim> reference = round.reference(round.corner_of_part(first, corner));
      result.vertices[corner] = round.place(reference);
      const std::vector<double> values =
          values_at(result.vertices[corner], interpolated(whole, reference));
      for (unsigned int row = 0; row < values.size(); ++row)
        result.data(row, corner) = static_cast<float>(values[row]);
    }
    return result;
  }

  static std::vector<double> interpolated(const Patch& whole, const Point<dim>& reference) {
    std::vector<double> values(whole.data.n_rows(), 0.);
    for (unsigned int row = 0; row < values.size(); ++row)
      for (unsigned int i = 0; i < n_corners; ++i)
        values[row] += dealii::GeometryInfo<dim>::d_linear_shape_function(reference, i) *
                       static_cast<double>(whole.data(row, i));
    return values;
  }

  bool tensors_apart_ = false;
};

/// Displacement in output units.
template <int dim>
class DisplacementOutput : public dealii::DataPostprocessorVector<dim> {
 public:
  explicit DisplacementOutput(const double factor)
      : dealii::DataPostprocessorVector<dim>("displacement", dealii::update_values),
        factor_(factor) {}

  void evaluate_vector_field(const dealii::DataPostprocessorInputs::Vector<dim>& inputs,
                             std::vector<dealii::Vector<double>>& outputs) const override {
    for (unsigned int q = 0; q < outputs.size(); ++q)
      for (unsigned int component = 0; component < dim; ++component)
        outputs[q][component] = factor_ * inputs.solution_values[q](component);
  }

 private:
  double factor_;
};

enum class ArrayKind { number, tensor };

/// A named stress output.
struct StressArray {
  const char* name;
  ArrayKind kind;
  bool only_in_plane;
};
constexpr std::array<StressArray, 10> all_stress_arrays{
    {{"stress", ArrayKind::tensor, false},
     {"stress_out_of_plane", ArrayKind::number, true},
     {"von_mises", ArrayKind::number, false},
     {"principal_stress_1", ArrayKind::number, false},
     {"principal_stress_2", ArrayKind::number, false},
     {"principal_stress_3", ArrayKind::number, false},
     {"max_shear", ArrayKind::number, false},
     {"mcewen_stress", ArrayKind::tensor, true},
     {"mcewen_difference", ArrayKind::tensor, true},
     {"mcewen_zone", ArrayKind::number, true}}};

template <int dim>
std::vector<StressArray> stress_arrays() {
  std::vector<StressArray> arrays;
  for (const StressArray& array : all_stress_arrays)
    if (dim == 2 || !array.only_in_plane) arrays.push_back(array);
  return arrays;
}

template <int dim>
unsigned int n_components(const StressArray& array) {
  return array.kind == ArrayKind::tensor ? dim * dim : 1;
}

/// Writes numbers one after the other.
class Writer {
 public:
  Writer(dealii::Vector<double>& output, const double factor) : output_(output), factor_(factor) {}

  void plain(const double value) { output_[next_++] = value; }
  void scaled(const double value) { plain(factor_ * value); }
  template <int dim>
  void scaled(const dealii::SymmetricTensor<2, dim>& tensor) {
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j) scaled(tensor[i][j]);
  }

 private:
  dealii::Vector<double>& output_;
  double factor_;
  unsigned int next_ = 0;
};

/// What all dimensions have after the stress itself.
template <typename Stress>
void write_invariants(const Stress& stress, Writer& writer) {
  const auto principal = principal_stresses(stress);
  writer.scaled(von_mises(principal));
  for (const double value : principal) writer.scaled(value);
  writer.scaled(max_shear(principal));
}

/// All stress arrays of a node, from its recovered stress.
template <int dim>
class StressOutput : public dealii::DataPostprocessor<dim> {
 public:
  StressOutput(const fem::Solution<dim>& solution, const Results<dim>& results, const double factor)
      : solution_(solution), results_(results), factor_(factor) {}

  [[nodiscard]] std::vector<std::string> get_names() const override {
    std::vector<std::string> names;
    for (const StressArray& array : stress_arrays<dim>())
      names.insert(names.end(), n_components<dim>(array), array.name);
    return names;
  }

  [[nodiscard]] std::vector<Interpretation> get_data_component_interpretation() const override {
    std::vector<Interpretation> interpretation;
    for (const StressArray& array : stress_arrays<dim>())
      interpretation.insert(interpretation.end(), n_components<dim>(array),
                            array.kind == ArrayKind::tensor ? tensor_part : scalar);
    return interpretation;
  }

  [[nodiscard]] dealii::UpdateFlags get_needed_update_flags() const override {
    return dealii::update_values | dealii::update_quadrature_points;
  }

  void evaluate_vector_field(const dealii::DataPostprocessorInputs::Vector<dim>& inputs,
                             std::vector<dealii::Vector<double>>& outputs) const override {
    const unsigned int body = inputs.template get_cell<dim>()->material_id();
    for (unsigned int q = 0; q < outputs.size(); ++q) {
      const auto& values = inputs.solution_values[q];
      const auto stress =
          assembled_stress<dim>([&](const unsigned int component) { return values[component]; });
      const Point<dim> place = solution_.scales.length * inputs.evaluation_points[q];
      write(stress, body, place, outputs[q]);
    }
  }

  /// Sets all arrays of a point anew from the stress tensor, their first components.
  /// @param values by array; those of the stress begin at `begin` [output units]
  /// @param place [m]
  void renew(std::vector<double>& values, const std::size_t begin, const unsigned int body,
             const Point<dim>& place) const {
    constexpr std::size_t width = dim;
    const auto row = [&](const unsigned int i, const unsigned int j) {
      return values[begin + i * width + j] / factor_;
    };
    Stress<dim> stress;
    if constexpr (dim == 2) {
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = i; j < 2; ++j) stress.in_plane[i][j] = row(i, j);
      stress.out_of_plane = values[begin + width * width] / factor_;
    } else {
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = i; j < 3; ++j) stress[i][j] = row(i, j);
    }
    dealii::Vector<double> output(static_cast<unsigned int>(get_names().size()));
    write(stress, body, place, output);
    std::copy(output.begin(), output.end(), values.begin() + static_cast<std::ptrdiff_t>(begin));
  }

 private:
  [[nodiscard]] std::optional<fem::PlaneStress> closed_form_at(const unsigned int body,
                                                               const Point<2>& place) const {
    for (const auto& contact : results_.contacts)
      if (contact.hertz) {
        const double poissons_ratio = solution_.problem.bodies[body].material.poissons_ratio;
        const auto stress =
            mcewen_stress(*contact.hertz, solution_.problem.plane, poissons_ratio, place);
        if (stress) return stress;
      }
    return std::nullopt;
  }

  void write(const Stress<dim>& stress, [[maybe_unused]] const unsigned int body,
             [[maybe_unused]] const Point<dim>& place, dealii::Vector<double>& output) const {
    Writer writer(output, factor_);
    if constexpr (dim == 3) {
      writer.scaled(stress);
      write_invariants(stress, writer);
    } else {
      const auto exact = closed_form_at(body, place);
      writer.scaled(stress.in_plane);
      writer.scaled(stress.out_of_plane);
      write_invariants(stress, writer);
      writer.scaled(exact ? exact->in_plane : dealii::SymmetricTensor<2, 2>());
      writer.scaled(exact ? stress.in_plane - exact->in_plane : dealii::SymmetricTensor<2, 2>());
      writer.plain(exact ? 1. : 0.);
    }
  }

  const fem::Solution<dim>& solution_;
  const Results<dim>& results_;
  double factor_;
};

/// @param length of the triangulation's unit [m]
template <int dim>
typename ScaledDataOut<dim>::ValuesAt renewed_by(const StressOutput<dim>& stress,
                                                 const double length) {
  return [&stress, length](const auto& cell, const Point<dim>& place,
                           const std::vector<double>& interpolated) {
    std::vector<double> values = interpolated;
    stress.renew(values, dim, cell->material_id(), length * place);  // displacements stand before
    return values;
  };
}

dealii::DataOutBase::VtkFlags vtk_flags(const UnitSystem units) {
  dealii::DataOutBase::VtkFlags flags;
  flags.compression_level = dealii::DataOutBase::VtkFlags::best_speed;
  flags.physical_units["displacement"] = output_unit(units, Dimension::length).name;
  for (const StressArray& array : all_stress_arrays)
    if (std::string(array.name) != "mcewen_zone")
      flags.physical_units[array.name] = output_unit(units, Dimension::stress).name;
  return flags;
}

template <int dim>
dealii::Vector<double> bodies(const fem::Solution<dim>& solution) {
  dealii::Vector<double> body(solution.triangulation->n_active_cells());
  for (const auto& cell : solution.triangulation->active_cell_iterators())
    body[cell->active_cell_index()] = cell->material_id();
  return body;
}

template <int dim>
void write_vtu(const ScaledDataOut<dim>& data, const MPI_Comm communicator,
               const fs::path& directory) try {
  const unsigned int ranks = dealii::Utilities::MPI::n_mpi_processes(communicator);
  const unsigned int rank = dealii::Utilities::MPI::this_mpi_process(communicator);
  const auto piece_name = [](const unsigned int i) { return fmt::format("solution.{}.vtu", i); };
  const fs::path piece = own_file(directory, piece_name(rank));
  std::ofstream stream = base::open_output(piece);
  data.write_vtu(stream);
  base::close_output(stream, piece);
  if (rank != 0) return;
  std::vector<std::string> pieces;
  for (unsigned int i = 0; i < ranks; ++i) pieces.push_back(piece_name(i));
  const fs::path record = own_file(directory, "solution.pvtu");
  stream = base::open_output(record);
  data.write_pvtu_record(stream, pieces);
  base::close_output(stream, record);
  const fs::path collection = own_file(directory, "solution.pvd");
  stream = base::open_output(collection);
  dealii::DataOutBase::write_pvd_record(stream, {{0., "solution.pvtu"}});
  base::close_output(stream, collection);
} catch (const dealii::ExceptionBase&) {
  base::refuse_by_system("cannot write all of the fields in " + directory.string());
}

/// The history of the refinement as one data set a column.
void add_history(const std::vector<fem::LevelRecord>& levels, Hdf5Image& image) {
  std::map<std::string, std::vector<double>> columns;
  for (const fem::LevelRecord& level : levels) {
    columns["cells"].push_back(level.cells);
    columns["dofs"].push_back(level.dofs);
    columns["peak_pressure_Pa"].push_back(level.peak_pressure);
    columns["error_estimate"].push_back(level.error_estimate);
    columns["active_nodes"].push_back(level.active_nodes);
    columns["active_set_iterations"].push_back(static_cast<double>(level.linear_iterations.size()));
  }
  image.add_group("history");
  for (const auto& [name, column] : columns) {
    image.add_table<double>("history/" + name, column.size(), 0);
    image.fill("history/" + name, 0, column);
  }
}

/// Hands the rows of all ranks to rank 0, one rank after the other.
template <typename Number>
void gather(const std::vector<Number>& own, const MPI_Comm communicator,
            const std::function<void(const std::vector<Number>&)>& take) {
  constexpr int tag = 71;
  const MPI_Datatype type = std::is_same_v<Number, double> ? MPI_DOUBLE : MPI_UNSIGNED;
  const auto ranks = static_cast<int>(dealii::Utilities::MPI::n_mpi_processes(communicator));
  if (dealii::Utilities::MPI::this_mpi_process(communicator) != 0) {
    MPI_Send(own.data(), static_cast<int>(own.size()), type, 0, tag, communicator);
    return;
  }
  take(own);
  for (int rank = 1; rank < ranks; ++rank) {
    MPI_Status status;
    int size = 0;
    MPI_Probe(rank, tag, communicator, &status);
    MPI_Get_count(&status, type, &size);
    std::vector<Number> values(static_cast<std::size_t>(size));
    MPI_Recv(values.data(), size, type, rank, tag, communicator, MPI_STATUS_IGNORE);
    take(values);
  }
}

/// Adds a table of the rows that all ranks have; the image is rank 0's.
template <typename Number>
void add_rows(const std::string& name, const std::size_t columns, const std::vector<Number>& own,
              const MPI_Comm communicator, Hdf5Image* const image) {
  const std::size_t rows = dealii::Utilities::MPI::sum(own.size() / columns, communicator);
  if (image) image->add_table<Number>(name, rows, columns);
  std::size_t begin = 0;
  gather<Number>(own, communicator, [&](const std::vector<Number>& values) {
    image->fill(name, begin, values);
    begin += values.size() / columns;
  });
}

/// The mesh and the values at its nodes, as data_out's own writer lays them out.
void add_fields(const dealii::DataOutBase::DataOutFilter& filter, const unsigned int dim,
                const MPI_Comm communicator, Hdf5Image* const image) {
  const unsigned int nodes = filter.n_nodes();
  std::vector<double> places;
  filter.fill_node_data(places);
  add_rows("nodes", dim, places, communicator, image);
  unsigned int before = 0;
  MPI_Exscan(&nodes, &before, 1, MPI_UNSIGNED, MPI_SUM, communicator);
  std::vector<unsigned int> cells;
  filter.fill_cell_data(before, cells);
  add_rows("cells", 1U << dim, cells, communicator, image);
  for (unsigned int i = 0; i < filter.n_data_sets(); ++i) {
    const std::size_t columns = filter.get_data_set_dim(i);
    const double* const begin = filter.get_data_set(i);
    add_rows(filter.get_data_set_name(i), columns,
             std::vector<double>(begin, begin + columns * nodes), communicator, image);
  }
}

/// Describes results.h5 to ParaView.
template <int dim>
std::string xdmf(const dealii::XDMFEntry& entry) {
  return fmt::format(R"(<?xml version="1.0" ?>
<!DOCTYPE Xdmf SYSTEM "Xdmf.dtd" []>
<Xdmf Version="2.0">
  <Domain>
    <Grid Name="CellTime" GridType="Collection" CollectionType="Temporal">
{}    </Grid>
  </Domain>
</Xdmf>
)",
                     entry.get_xdmf_content(3, dealii::ReferenceCells::get_hypercube<dim>()));
}

/// @throws base::InputError if not everything could be written
template <int dim>
void write_hdf5(const ScaledDataOut<dim>& data, const std::vector<fem::LevelRecord>& levels,
                const MPI_Comm communicator, const fs::path& directory) {
  // Duplicate vertices stay: the two bodies touch, and merging their vertices would average their
  // stresses.
  dealii::DataOutBase::DataOutFilter filter(dealii::DataOutBase::DataOutFilterFlags(false, true));
  data.write_filtered_data(filter);
  const dealii::XDMFEntry entry = data.create_xdmf_entry(filter, "results.h5", 0., communicator);
  std::optional<Hdf5Image> image;
  if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0) image.emplace();
  add_fields(filter, dim, communicator, image ? &*image : nullptr);
  if (!image) return;
  add_history(levels, *image);
  image->write(own_file(directory, "results.h5"));
  base::write_text(own_file(directory, "results.xdmf"), xdmf<dim>(entry));
}

}  // namespace

template <int dim>
void write_fields(const fem::Solution<dim>& solution, const Results<dim>& results,
                  const UnitSystem units, const fs::path& directory) {
  const MPI_Comm communicator = solution.dof_handler->get_communicator();
  const double length = solution.scales.length * output_unit(units, Dimension::length).factor;
  const DisplacementOutput<dim> displacement(length);
  const StressOutput<dim> stress(solution, results, output_unit(units, Dimension::stress).factor);
  const dealii::Vector<double> body = bodies(solution);

  ScaledDataOut<dim> data;
  data.set_flags(vtk_flags(units));
  data.attach_triangulation(*solution.triangulation);
  data.add_data_vector(*solution.dof_handler, solution.displacement, displacement);
  data.add_data_vector(*results.nodal.dof_handler, results.nodal.values, stress);
  data.add_data_vector(body, "body", dealii::DataOut<dim>::type_cell_data);
  data.build_patches();
  data.round(*solution.dof_handler, renewed_by(stress, solution.scales.length));
  data.scale_positions(length);
  write_vtu(data, communicator, directory);
  data.take_tensors_apart();
  write_hdf5(data, solution.history, communicator, directory);
}

template void write_fields(const fem::Solution<2>&, const Results<2>&, UnitSystem, const fs::path&);
template void write_fields(const fem::Solution<3>&, const Results<3>&, UnitSystem, const fs::path&);

}  // namespace geneva::post
