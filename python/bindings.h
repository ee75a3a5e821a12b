#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <exception>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "api/case.h"
#include "api/written.h"

namespace geneva::python {

namespace py = pybind11;

/// A figure as Python is given it; SI units, what is missing does not exist.
struct PlainFigure {
  std::string name;
  base::Dimension dimension;
  std::optional<double> value;
  std::optional<double> error = std::nullopt;  ///< relative
  std::optional<double> closed_form = std::nullopt;
  std::optional<double> published = std::nullopt;
  std::optional<double> limit = std::nullopt;
  std::optional<double> driver_angle = std::nullopt;  ///< [rad]
  bool is_bounded = true;
  std::string note = {};
};

inline py::dict as_dict(const PlainFigure& figure) {
  py::dict dict;
  dict["name"] = figure.name;
  dict["dimension"] = base::name_of(figure.dimension);
  dict["value"] = figure.value;
  dict["error"] = figure.error;
  dict["closed_form"] = figure.closed_form;
  dict["published"] = figure.published;
  dict["limit"] = figure.limit;
  dict["driver_angle"] = figure.driver_angle;
  dict["is_bounded"] = figure.is_bounded;
  dict["note"] = figure.note;
  return dict;
}

inline py::list as_list(const std::vector<PlainFigure>& figures) {
  py::list list;
  for (const PlainFigure& figure : figures) list.append(as_dict(figure));
  return list;
}

/// An array of its own with one number of each row.
template <typename Row, typename Number>
py::array_t<double> column(const std::vector<Row>& rows, const Number& number_of) {
  py::array_t<double> array(static_cast<py::ssize_t>(rows.size()));
  double* const values = array.mutable_data();
  for (std::size_t i = 0; i < rows.size(); ++i) values[i] = number_of(rows[i]);
  return array;
}

/// An array of its own, a row of it for each of the vectors.
template <std::size_t size>
py::array_t<double> matrix(const std::vector<std::array<double, size>>& rows) {
  py::array_t<double> array({rows.size(), size});
  auto values = array.mutable_unchecked<2>();
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < size; ++j)
      values(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(j)) = rows[i][j];
  return array;
}

inline double number_or_nan(const std::optional<double>& value) {
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

/// Curves by their names: an array, and the dimension of its numbers.
class Columns {
 public:
  template <typename Row, typename Number>
  void add(const char* const name, const base::Dimension dimension, const std::vector<Row>& rows,
           const Number& number_of) {
    dict_[name] = py::make_tuple(column(rows, number_of), base::name_of(dimension));
  }
  [[nodiscard]] const py::dict& dict() const { return dict_; }

 private:
  py::dict dict_;
};

/// What has been written, as a pair of lists.
inline py::tuple as_tuple(const Written& written) {
  return py::make_tuple(written.removed, written.missing_packages);
}

/// Calls back into Python from a computation that goes on without its lock. What the callback
/// raises, and the user's interruption, ends the computation and leaves it unchanged, whatever the
/// libraries between make of it.
class Teller {
 public:
  /// @param callback it must outlive the teller; None: nobody is told
  explicit Teller(const py::object& callback) : callback_(callback) {}

  template <typename... Arguments>
  void tell(const Arguments&... arguments) {
    const py::gil_scoped_acquire lock;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (!callback_.is_none()) callback_(arguments...);
    } catch (const py::error_already_set&) {
      thrown_ = std::current_exception();
      throw;
    }
  }

  /// Computes without Python's lock.
  template <typename Task>
  auto compute(const Task& task) const {
    const py::gil_scoped_release unlocked;
    return rethrowing(task);
  }

  /// What a task returns, or else what the callback has raised in it.
  template <typename Task>
  auto rethrowing(const Task& task) const {
    try {
      return task();
    } catch (...) {
      if (thrown_) std::rethrow_exception(thrown_);
      throw;
    }
  }

 private:
  const py::object& callback_;
  std::exception_ptr thrown_;
};

/// What results have in common: their tables, documents, notices and files.
template <typename Result>
py::class_<Result> bind_result(py::module_& module, const char* const name) {
  return py::class_<Result>(module, name)
      .def_property_readonly("given", [](const Result& result) { return result.given; })
      .def(
          "write",
          [](const Result& result, const std::filesystem::path& directory) {
            Written written;
            {
              const py::gil_scoped_release unlocked;
              written = write(result, directory);
            }
            return as_tuple(written);
          },
          py::arg("directory"));
}

}  // namespace geneva::python
