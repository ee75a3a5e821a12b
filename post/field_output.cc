#include "post/field_output.h"

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/hdf5.h>
#include <deal.II/base/mpi.h>
#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/data_postprocessor.h>
#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include "post/output_file.h"

namespace geneva::post {

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
class ScaledDataOut : public dealii::DataOut<2> {
 public:
  void scale_positions(const double factor) {
    for (auto& patch : patches)
      for (auto& vertex : patch.vertices) vertex *= factor;
  }

  /// From now on each component of a tensor is an array of its own: HDF5 output knows no plane
  /// tensors and would keep only some of their components.
  void take_tensors_apart() { tensors_apart_ = true; }

 protected:
  [[nodiscard]] std::vector<std::string> get_dataset_names() const override {
    std::vector<std::string> names = dealii::DataOut<2>::get_dataset_names();
    if (!tensors_apart_) return names;
    constexpr std::array<const char*, 4> components{"_xx", "_xy", "_yx", "_yy"};
    for (const auto& range : dealii::DataOut<2>::get_nonscalar_data_ranges())
      if (std::get<3>(range) == tensor_part)
        for (unsigned int i = 0; i < components.size(); ++i)
          names[std::get<0>(range) + i] += components[i];
    return names;
  }

  [[nodiscard]] NonscalarRanges get_nonscalar_data_ranges() const override {
    NonscalarRanges ranges = dealii::DataOut<2>::get_nonscalar_data_ranges();
    if (tensors_apart_)
      ranges.erase(
          std::remove_if(ranges.begin(), ranges.end(),
                         [](const auto& range) { return std::get<3>(range) == tensor_part; }),
          ranges.end());
    return ranges;
  }

 private:
  bool tensors_apart_ = false;
};

/// Displacement in output units.
class DisplacementOutput : public dealii::DataPostprocessorVector<2> {
 public:
  explicit DisplacementOutput(const double factor)
      : dealii::DataPostprocessorVector<2>("displacement", dealii::update_values),
        factor_(factor) {}

  void evaluate_vector_field(const dealii::DataPostprocessorInputs::Vector<2>& inputs,
                             std::vector<dealii::Vector<double>>& outputs) const override {
    for (unsigned int q = 0; q < outputs.size(); ++q)
      for (unsigned int component = 0; component < 2; ++component)
        outputs[q][component] = factor_ * inputs.solution_values[q](component);
  }

 private:
  double factor_;
};

/// A named stress output with as many numbers as its interpretation says.
struct StressArray {
  const char* name;
  unsigned int components;
};
constexpr std::array<StressArray, 10> stress_arrays{{{"stress", 4},
                                                     {"stress_out_of_plane", 1},
                                                     {"von_mises", 1},
                                                     {"principal_stress_1", 1},
                                                     {"principal_stress_2", 1},
                                                     {"principal_stress_3", 1},
                                                     {"max_shear", 1},
                                                     {"mcewen_stress", 4},
                                                     {"mcewen_difference", 4},
                                                     {"mcewen_zone", 1}}};

fem::PlaneStress to_stress(const dealii::Vector<double>& values) {
  fem::PlaneStress stress;
  stress.in_plane[0][0] = values[0];
  stress.in_plane[1][1] = values[1];
  stress.in_plane[0][1] = values[3];
  stress.out_of_plane = values[2];
  return stress;
}

/// All stress arrays of a node, from its recovered stress.
class StressOutput : public dealii::DataPostprocessor<2> {
 public:
  StressOutput(const fem::Solution<2>& solution, const Results& results, const double factor)
      : solution_(solution), results_(results), factor_(factor) {}

  [[nodiscard]] std::vector<std::string> get_names() const override {
    std::vector<std::string> names;
    for (const StressArray& array : stress_arrays)
      names.insert(names.end(), array.components, array.name);
    return names;
  }

  [[nodiscard]] std::vector<Interpretation> get_data_component_interpretation() const override {
    std::vector<Interpretation> interpretation;
    for (const StressArray& array : stress_arrays)
      interpretation.insert(interpretation.end(), array.components,
                            array.components == 4 ? tensor_part : scalar);
    return interpretation;
  }

  [[nodiscard]] dealii::UpdateFlags get_needed_update_flags() const override {
    return dealii::update_values | dealii::update_quadrature_points;
  }

  void evaluate_vector_field(const dealii::DataPostprocessorInputs::Vector<2>& inputs,
                             std::vector<dealii::Vector<double>>& outputs) const override {
    const unsigned int body = inputs.get_cell<2>()->material_id();
    for (unsigned int q = 0; q < outputs.size(); ++q) {
      const fem::PlaneStress stress = to_stress(inputs.solution_values[q]);
      const Point<2> place = solution_.scales.length * inputs.evaluation_points[q];
      write(stress, closed_form_at(body, place), outputs[q]);
    }
  }

 private:
  [[nodiscard]] std::optional<fem::PlaneStress> closed_form_at(const unsigned int body,
                                                               const Point<2>& place) const {
    for (const ContactAnalysis& contact : results_.contacts)
      if (contact.hertz) {
        const double poissons_ratio = solution_.problem.bodies[body].material.poissons_ratio;
        const auto stress =
            mcewen_stress(*contact.hertz, solution_.problem.plane, poissons_ratio, place);
        if (stress) return stress;
      }
    return std::nullopt;
  }

  void write(const fem::PlaneStress& stress, const std::optional<fem::PlaneStress>& exact,
             dealii::Vector<double>& output) const {
    unsigned int next = 0;
    const auto put = [&](const double value) { output[next++] = value; };
    const auto put_tensor = [&](const dealii::SymmetricTensor<2, 2>& tensor) {
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = 0; j < 2; ++j) put(factor_ * tensor[i][j]);
    };
    const auto principal = principal_stresses(stress);
    put_tensor(stress.in_plane);
    put(factor_ * stress.out_of_plane);
    put(factor_ * von_mises(principal));
    for (const double value : principal) put(factor_ * value);
    put(factor_ * max_shear(principal));
    put_tensor(exact ? exact->in_plane : dealii::SymmetricTensor<2, 2>());
    put_tensor(exact ? stress.in_plane - exact->in_plane : dealii::SymmetricTensor<2, 2>());
    put(exact ? 1. : 0.);
  }

  const fem::Solution<2>& solution_;
  const Results& results_;
  double factor_;
};

dealii::DataOutBase::VtkFlags vtk_flags(const UnitSystem units) {
  dealii::DataOutBase::VtkFlags flags;
  flags.compression_level = dealii::DataOutBase::VtkFlags::best_speed;
  flags.physical_units["displacement"] = output_unit(units, Dimension::length).name;
  for (const StressArray& array : stress_arrays)
    if (std::string(array.name) != "mcewen_zone")
      flags.physical_units[array.name] = output_unit(units, Dimension::stress).name;
  return flags;
}

dealii::Vector<double> bodies(const fem::Solution<2>& solution) {
  dealii::Vector<double> body(solution.triangulation->n_active_cells());
  for (const auto& cell : solution.triangulation->active_cell_iterators())
    body[cell->active_cell_index()] = cell->material_id();
  return body;
}

void write_vtu(const ScaledDataOut& data, const MPI_Comm communicator, const fs::path& directory) {
  const unsigned int ranks = dealii::Utilities::MPI::n_mpi_processes(communicator);
  const unsigned int rank = dealii::Utilities::MPI::this_mpi_process(communicator);
  const auto piece_name = [](const unsigned int i) { return fmt::format("solution.{}.vtu", i); };
  const fs::path piece = directory / piece_name(rank);
  std::ofstream stream = open_output(piece);
  data.write_vtu(stream);
  close_output(stream, piece);
  if (rank != 0) return;
  std::vector<std::string> pieces;
  for (unsigned int i = 0; i < ranks; ++i) pieces.push_back(piece_name(i));
  const fs::path record = directory / "solution.pvtu";
  stream = open_output(record);
  data.write_pvtu_record(stream, pieces);
  close_output(stream, record);
  const fs::path collection = directory / "solution.pvd";
  stream = open_output(collection);
  dealii::DataOutBase::write_pvd_record(stream, {{0., "solution.pvtu"}});
  close_output(stream, collection);
}

/// The history of the refinement as one data set a column.
void append_history(const fem::Solution<2>& solution, const MPI_Comm communicator,
                    const fs::path& file) {
  std::map<std::string, std::vector<double>> columns;
  for (const fem::LevelRecord& level : solution.history) {
    columns["cells"].push_back(level.cells);
    columns["dofs"].push_back(level.dofs);
    columns["peak_pressure_Pa"].push_back(level.peak_pressure);
    columns["error_estimate"].push_back(level.error_estimate);
    columns["active_nodes"].push_back(level.active_nodes);
    columns["active_set_iterations"].push_back(static_cast<double>(level.linear_iterations.size()));
  }
  dealii::HDF5::File results(file.string(), dealii::HDF5::File::FileAccessMode::open, communicator);
  dealii::HDF5::Group history = results.create_group("history");
  for (const auto& [name, column] : columns) history.write_dataset(name, column);
}

/// @throws std::runtime_error if the disk is full
void write_hdf5(const ScaledDataOut& data, const fem::Solution<2>& solution,
                const MPI_Comm communicator, const fs::path& directory) try {
  H5Eset_auto(H5E_DEFAULT, nullptr, nullptr);  // failures are said below, not as a stack of calls
  // Duplicate vertices stay: the two bodies touch, and merging their vertices would average their
  // stresses.
  dealii::DataOutBase::DataOutFilter filter(dealii::DataOutBase::DataOutFilterFlags(false, true));
  data.write_filtered_data(filter);
  const fs::path file = directory / "results.h5";
  data.write_hdf5_parallel(filter, file.string(), communicator);
  const dealii::XDMFEntry entry = data.create_xdmf_entry(filter, "results.h5", 0., communicator);
  data.write_xdmf_file({entry}, (directory / "results.xdmf").string(), communicator);
  append_history(solution, communicator, file);
} catch (const dealii::ExceptionBase&) {
  throw std::runtime_error("cannot write all of " + (directory / "results.h5").string() +
                           ": is the disk full?");
}

}  // namespace

void write_fields(const fem::Solution<2>& solution, const Results& results, const UnitSystem units,
                  const fs::path& directory) {
  const MPI_Comm communicator = solution.dof_handler->get_communicator();
  const double length = solution.scales.length * output_unit(units, Dimension::length).factor;
  const DisplacementOutput displacement(length);
  const StressOutput stress(solution, results, output_unit(units, Dimension::stress).factor);
  const dealii::Vector<double> body = bodies(solution);

  ScaledDataOut data;
  data.set_flags(vtk_flags(units));
  data.attach_triangulation(*solution.triangulation);
  data.add_data_vector(*solution.dof_handler, solution.displacement, displacement);
  data.add_data_vector(*results.nodal.dof_handler, results.nodal.values, stress);
  data.add_data_vector(body, "body", dealii::DataOut<2>::type_cell_data);
  data.build_patches();
  data.scale_positions(length);
  write_vtu(data, communicator, directory);
  data.take_tensors_apart();
  write_hdf5(data, solution, communicator, directory);
}

}  // namespace geneva::post
