#include <pybind11/stl/filesystem.h>

#include <array>
#include <cmath>
#include <new>

#include "api/crown.h"
#include "api/design.h"
#include "api/estimate.h"
#include "api/kinematics.h"
#include "api/optimisation.h"
#include "api/report.h"
#include "api/sweep.h"
#include "api/synthesis.h"
#include "api/version.h"
#include "python/bindings.h"

namespace geneva::python {

namespace {

using base::Dimension;

/// An exception of the package, which is told to programs that unpickle it by that name.
py::object exception_type(py::module_& module, const char* const name, PyObject* const kind,
                          const char* const meaning) {
  const std::string whole = std::string("geneva.") + name;
  auto type = py::reinterpret_steal<py::object>(
      PyErr_NewExceptionWithDoc(whole.c_str(), meaning, kind, nullptr));
  if (!type) throw py::error_already_set();
  module.attr(name) = type;
  return type;
}

void bind_errors(py::module_& module) {
  static PyObject* const input_error =
      exception_type(module, "InputError", PyExc_ValueError,
                     "What can be mended: in the case, in the call, or on the machine.")
          .release()
          .ptr();
  static PyObject* const limit_reached =
      exception_type(module, "LimitReached", PyExc_RuntimeError,
                     "A limit that the case sets was reached before there was a result.")
          .release()
          .ptr();
  exception_type(module, "EndedByOtherRank", PyExc_RuntimeError,
                 "What another rank's exception, such as its user's interruption, makes of this "
                 "one's computation.");
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const InputError& error) {
      PyErr_SetString(input_error, error.what());
    } catch (const std::filesystem::filesystem_error& error) {
      PyErr_SetString(input_error, error.what());
    } catch (const LimitReached& error) {
      PyErr_SetString(limit_reached, error.what());
    }
  });
}

const char* model_of(const Case& given) {
  return given.mechanism ? "mechanism" : given.geometry ? "geometry" : "synthesis";
}

/// What the text of a case says, as (section, name, value).
py::list assignments_of(const ParameterText& text) {
  py::list list;
  for (const model::Assignment& one : text.assignments)
    list.append(py::make_tuple(one.section, one.name, one.value));
  return list;
}

ParameterText empty_text(const std::string& name) {
  ParameterText text;
  text.file = name;
  text.varied_by = "";
  return text;
}

Case case_of_settings(const std::vector<Setting>& settings, const std::string& name,
                      const std::filesystem::path& directory) {
  return case_with(empty_text(name), settings, directory);
}

Case changed_case(const Case& given, const std::vector<Setting>& settings) {
  ParameterText text = given.text;
  if (!text.varied_by.empty()) text.varied_by = "with_";
  return case_with(text, settings, given.directory);
}

/// What a pickled case holds: its text with the places of its lines, and its directory.
py::tuple pickled(const Case& given) {
  py::list lines;
  for (const model::Assignment& one : given.text.assignments)
    lines.append(py::make_tuple(one.section, one.name, one.value, one.line, one.is_filled_in));
  return py::make_tuple(given.text.file, given.text.varied_by, lines, given.directory);
}

Case unpickled(const py::tuple& state) {
  ParameterText text;
  text.file = state[0].cast<std::string>();
  text.varied_by = state[1].cast<std::string>();
  for (const py::handle line : state[2]) {
    const auto part = py::reinterpret_borrow<py::tuple>(line);
    text.assignments.push_back({part[0].cast<model::SectionPath>(), part[1].cast<std::string>(),
                                part[2].cast<std::string>(), part[3].cast<int>(),
                                part[4].cast<bool>()});
  }
  return model::case_of(text, state[3].cast<std::filesystem::path>());
}

void bind_case(py::module_& module) {
  py::class_<Setting>(module, "Setting")
      .def(py::init<model::SectionPath, std::string,
                    std::variant<std::string, std::vector<double>>>(),
           py::arg("section"), py::arg("name"), py::arg("value"));
  py::class_<Case>(module, "Case")
      .def_readonly("directory", &Case::directory)
      .def_readonly("title", &Case::title)
      .def_readonly("dimension", &Case::dimension)
      .def_readonly("completed", &Case::completed)
      .def_property_readonly("name", [](const Case& given) { return model::name_of(given); })
      .def_property_readonly("model", model_of)
      .def_property_readonly("units", [](const Case& given) { return base::name_of(given.units); })
      .def_property_readonly("assignments",
                             [](const Case& given) { return assignments_of(given.text); })
      .def("changed", changed_case, py::arg("settings"))
      .def(py::pickle([](const Case& given) { return pickled(given); },
                      [](const py::tuple& state) { return unpickled(state); }));
  module.def("read_case", read_case, py::arg("directory"));
  module.def("new_case", case_of_settings, py::arg("settings"), py::arg("name"),
             py::arg("directory"));
  module.def(
      "starter_case",
      [](const std::string& type, const std::optional<int> stations, const std::string& units,
         const std::filesystem::path& directory) {
        const auto files = model::starter_case({type, stations, base::unit_system_named(units)});
        if (files.size() > 1)
          throw InputError("'" + type +
                           "': such a case has a file beside its case.prm; write it by 'geneva "
                           "init --type " +
                           type + " DIR' and read it");
        return model::case_of(model::parameter_text("the new case", files.front().text), directory);
      },
      py::arg("type"), py::arg("stations"), py::arg("units"), py::arg("directory"));
}

void bind_units(py::module_& module) {
  module.def(
      "output_unit",
      [](const std::string& system, const std::string& dimension) {
        const base::OutputUnit unit =
            base::output_unit(base::unit_system_named(system), base::dimension_named(dimension));
        return py::make_tuple(unit.name, unit.factor);
      },
      py::arg("system"), py::arg("dimension"));
}

std::vector<PlainFigure> plain(const std::vector<post::LimitRow>& rows) {
  std::vector<PlainFigure> figures;
  for (const post::LimitRow& row : rows) {
    PlainFigure figure{row.quantity, row.dimension, row.value};
    figure.limit = row.allowed;
    figure.driver_angle = row.driver_angle;
    figure.note = row.meaning;
    figures.push_back(figure);
  }
  return figures;
}

std::vector<PlainFigure> plain(const std::vector<post::SweepFigure>& found) {
  std::vector<PlainFigure> figures;
  for (const post::SweepFigure& one : found) {
    PlainFigure figure{one.quantity, one.dimension, one.value, one.error};
    figure.limit = one.limit;
    figure.is_bounded = one.value.has_value();
    figures.push_back(figure);
  }
  return figures;
}

std::vector<PlainFigure> figures_of(const Kinematics& found) {
  std::vector<PlainFigure> figures;
  std::string above;  // an indented row belongs to it
  for (const post::CharacteristicRow& row :
       post::characteristic_rows(found.report.values, found.report.reference_speed)) {
    const std::size_t begin = row.quantity.find_first_not_of(' ');
    if (begin == 0) above = row.quantity;
    const std::string name = begin == 0 ? above : above + ", " + row.quantity.substr(begin);
    PlainFigure figure{name, row.dimension, row.value};
    figure.driver_angle = row.driver_angle;
    figure.note = row.meaning;
    figures.push_back(figure);
  }
  return figures;
}

py::dict curves_of(const Kinematics& found) {
  using Row = loads::KinematicsRow;
  const auto& rows = found.report.rows;
  const double speed = found.report.reference_speed;
  Columns columns;
  columns.add("time", Dimension::time, rows, [](const Row& row) { return row.load.time; });
  columns.add("driver angle", Dimension::angle, rows,
              [](const Row& row) { return row.load.driver_angle; });
  columns.add("driver speed", Dimension::angular_speed, rows,
              [](const Row& row) { return row.load.driver_speed; });
  columns.add("driver acceleration", Dimension::angular_acceleration, rows,
              [](const Row& row) { return row.load.driver_acceleration; });
  columns.add("wheel angle", Dimension::angle, rows,
              [](const Row& row) { return row.motion.wheel_angle.value; });
  columns.add("wheel speed", Dimension::angular_speed, rows,
              [](const Row& row) { return row.motion.wheel_angle.first; });
  columns.add("wheel acceleration", Dimension::angular_acceleration, rows,
              [](const Row& row) { return row.motion.wheel_angle.second; });
  columns.add("speed ratio", Dimension::dimensionless, rows,
              [=](const Row& row) { return row.motion.wheel_angle.first / speed; });
  columns.add("acceleration ratio", Dimension::dimensionless, rows,
              [=](const Row& row) { return row.motion.wheel_angle.second / std::pow(speed, 2); });
  columns.add("jerk ratio", Dimension::dimensionless, rows,
              [=](const Row& row) { return row.motion.wheel_angle.third / std::pow(speed, 3); });
  columns.add("pin distance", Dimension::length, rows,
              [](const Row& row) { return row.load.pin_distance; });
  columns.add("travel speed", Dimension::speed, rows,
              [](const Row& row) { return row.load.travel_speed; });
  columns.add("slip speed", Dimension::speed, rows,
              [](const Row& row) { return row.load.slip_speed; });
  columns.add("bore speed", Dimension::speed, rows,
              [](const Row& row) { return row.load.bore_speed; });
  columns.add("moment", Dimension::moment, rows, [](const Row& row) { return row.load.moment; });
  columns.add("pin force", Dimension::force, rows, [](const Row& row) { return row.load.force; });
  columns.add("Hertz pressure", Dimension::stress, rows,
              [](const Row& row) { return row.pressure; });
  return columns.dict();
}

void bind_kinematics(py::module_& module) {
  bind_result<Kinematics>(module, "Kinematics")
      .def_readonly("notices", &Kinematics::notices)
      .def("table", [](const Kinematics& found) { return table(found); })
      .def("document",
           [](const Kinematics& found) { return post::kinematics_summary(found.report).dump(); })
      .def("figures", [](const Kinematics& found) { return as_list(figures_of(found)); })
      .def("limits", [](const Kinematics& found) { return as_list(plain(found.report.limits)); })
      .def("curves", curves_of)
      .def("walls", [](const Kinematics& found) {
        py::list walls;
        for (const loads::KinematicsRow& row : found.report.rows)
          walls.append(post::name_of(row.load.wall));
        return walls;
      });
  module.def("kinematics", &kinematics, py::arg("given"), py::arg("steps"),
             py::call_guard<py::gil_scoped_release>());
}

py::dict curves_of(const Estimate& found) {
  using Point = post::EngagementPoint;
  const auto& points = found.report.engagement;
  Columns columns;
  columns.add("driver angle", Dimension::angle, points,
              [](const Point& point) { return point.driver_angle; });
  columns.add("pin force", Dimension::force, points,
              [](const Point& point) { return point.force; });
  columns.add("Hertz pressure", Dimension::stress, points,
              [](const Point& point) { return point.even_pressure; });
  columns.add("peak pressure", Dimension::stress, points,
              [](const Point& point) { return number_or_nan(point.peak_pressure); });
  return columns.dict();
}

/// The pin's line load by line contacts; empty in the plane, and where they know no answer.
py::dict pin_of(const Estimate& found) {
  if (!found.report.line) return {};
  Columns columns;
  const auto& sections = found.report.line->sections;
  columns.add("z", Dimension::length, sections,
              [](const loads::PinSection& section) { return section.place; });
  columns.add("line load", Dimension::force_per_length, sections,
              [](const loads::PinSection& section) { return section.line_load; });
  return columns.dict();
}

void bind_estimate(py::module_& module) {
  bind_result<Estimate>(module, "Estimate")
      .def_readonly("notices", &Estimate::notices)
      .def_property_readonly("left_out",
                             [](const Estimate& found) { return found.report.left_out; })
      .def("table", [](const Estimate& found) { return table(found); })
      .def("document",
           [](const Estimate& found) { return post::estimate_summary(found.report).dump(); })
      .def("figures",
           [](const Estimate& found) {
             std::vector<PlainFigure> figures;
             for (const post::EstimateRow& row : found.report.rows) {
               PlainFigure figure{row.quantity, row.dimension, row.value};
               figure.note = row.basis;
               figures.push_back(figure);
             }
             return as_list(figures);
           })
      .def("limits", [](const Estimate& found) { return as_list(plain(found.report.limits)); })
      .def("curves", py::overload_cast<const Estimate&>(curves_of))
      .def("pin", pin_of);
  module.def("estimate", &estimate, py::arg("given"), py::call_guard<py::gil_scoped_release>());
}

double of_wheel(const std::optional<loads::DesignedWheel>& wheel,
                double loads::DesignedWheel::*const figure) {
  return wheel ? (*wheel).*figure : std::numeric_limits<double>::quiet_NaN();
}

py::dict curves_of(const Design& found) {
  using Point = loads::DesignPoint;
  using Wheel = loads::DesignedWheel;
  const auto& points = found.report.curve;
  Columns columns;
  columns.add("diameter", Dimension::length, points,
              [](const Point& point) { return point.diameter; });
  columns.add("inertia by Johnson", Dimension::inertia, points,
              [](const Point& point) { return of_wheel(point.johnson, &Wheel::inertia); });
  columns.add("pin force by Johnson", Dimension::force, points,
              [](const Point& point) { return of_wheel(point.johnson, &Wheel::force); });
  columns.add("peak pressure by Johnson", Dimension::stress, points,
              [](const Point& point) { return of_wheel(point.johnson, &Wheel::peak_pressure); });
  columns.add("inertia as drawn", Dimension::inertia, points,
              [](const Point& point) { return of_wheel(point.drawn, &Wheel::inertia); });
  columns.add("pin force as drawn", Dimension::force, points,
              [](const Point& point) { return of_wheel(point.drawn, &Wheel::force); });
  columns.add("peak pressure as drawn", Dimension::stress, points,
              [](const Point& point) { return of_wheel(point.drawn, &Wheel::peak_pressure); });
  return columns.dict();
}

py::dict strength_of(const Design& found) {
  using Wheel = post::WheelStrength;
  const auto& wheels = found.report.strength;
  Columns columns;
  columns.add("diameter", Dimension::length, wheels,
              [](const Wheel& wheel) { return wheel.diameter; });
  columns.add("peak pressure", Dimension::stress, wheels,
              [](const Wheel& wheel) { return wheel.peak_pressure; });
  columns.add("von Mises stress", Dimension::stress, wheels,
              [](const Wheel& wheel) { return wheel.von_mises; });
  columns.add("tensile stress", Dimension::stress, wheels,
              [](const Wheel& wheel) { return wheel.tensile; });
  return columns.dict();
}

void bind_design(py::module_& module) {
  bind_result<Design>(module, "Design")
      .def_readonly("notices", &Design::notices)
      .def("table", [](const Design& found) { return table(std::vector<Design>{found}); })
      .def("document",
           [](const Design& found) { return post::design_summary(found.report).dump(); })
      .def("figures",
           [](const Design& found) {
             return as_list(plain(geneva::figures_of(found.given, "design")));
           })
      .def("curves", py::overload_cast<const Design&>(curves_of))
      .def("strength", strength_of);
  module.def("design", &design, py::arg("given"), py::call_guard<py::gil_scoped_release>());
}

py::dict line_load_of(const loads::LoadEvenness& evenness) {
  Columns columns;
  columns.add("z", Dimension::length, evenness.sections,
              [](const loads::LoadedPlace& place) { return place.z; });
  columns.add("line load", Dimension::force_per_length, evenness.sections,
              [](const loads::LoadedPlace& place) { return place.line_load; });
  columns.add("peak pressure", Dimension::stress, evenness.sections,
              [](const loads::LoadedPlace& place) { return place.peak_pressure; });
  return columns.dict();
}

void bind_crown(py::module_& module) {
  bind_result<Crown>(module, "Crown")
      .def_readonly("best", &Crown::best)
      .def_property_readonly("parameter", [](const Crown& found) { return found.report.parameter; })
      .def_property_readonly("size", [](const Crown& found) { return found.report.size; })
      .def("table", [](const Crown& found) { return table(found); })
      .def("document", [](const Crown& found) { return post::crown_summary(found.report).dump(); })
      .def("before", [](const Crown& found) { return line_load_of(found.report.before); })
      .def("after", [](const Crown& found) { return line_load_of(found.report.after); });
  module.def("design_crown", &design_crown, py::arg("given"),
             py::call_guard<py::gil_scoped_release>());
}

void bind_synthesis(py::module_& module) {
  bind_result<Synthesis>(module, "Synthesis")
      .def_readonly("shortfall", &Synthesis::shortfall)
      .def("table", [](const Synthesis& found) { return table(found); })
      .def("document",
           [](const Synthesis& found) { return post::synthesis_summary(found.report).dump(); });
  module.def("synthesize", &synthesize, py::arg("given"), py::call_guard<py::gil_scoped_release>());
}

/// Before and after of the figures of an optimum; the figure by finite elements where it is known.
py::list figures_of(const Optimum& found) {
  std::vector<PlainFigure> figures;
  for (const post::OptimumFigure& row : found.report.figures) {
    PlainFigure figure{row.quantity, row.dimension, row.confirmed ? row.confirmed : row.after,
                       row.error};
    figure.closed_form = row.confirmed ? std::optional(row.after) : std::nullopt;
    figure.limit = row.limit;
    figure.note = row.place;
    figures.push_back(figure);
  }
  return as_list(figures);
}

void bind_optimum(py::module_& module) {
  bind_result<Optimum>(module, "Optimum")
      .def_readonly("best", &Optimum::best)
      .def("table", [](const Optimum& found) { return table(found); })
      .def("document",
           [](const Optimum& found) { return post::optimum_summary(found.report).dump(); })
      .def("figures", py::overload_cast<const Optimum&>(figures_of))
      .def("limits", [](const Optimum& found) { return as_list(plain(found.report.limits)); });
  module.def("wants_slot_bottom", wants_slot_bottom, py::arg("given"));
  module.def(
      "optimise",
      [](const Case& given, const py::object& progress) {
        Teller teller(progress);
        return teller.compute(
            [&] { return optimise(given, {}, [&](const int trials) { teller.tell(trials); }); });
      },
      py::arg("given"), py::arg("progress"));
}

/// The values of a parameter: a text as `geneva sweep --set` reads it, or one text or number for
/// each.
using SweptValues = std::variant<std::string, std::vector<std::string>, std::vector<double>>;

model::Variation variation_of(const Case& given, const model::SectionPath& section,
                              const std::string& name, const SweptValues& values) {
  if (const auto* const texts = std::get_if<std::vector<std::string>>(&values))
    return {section, name, *texts};
  if (const auto* const numbers = std::get_if<std::vector<double>>(&values)) {
    model::Variation variation{section, name, {}};
    for (const double number : *numbers)
      variation.values.push_back(model::text_of({section, name, std::vector<double>{number}},
                                                given.text, given.directory));
    return variation;
  }
  std::string path;
  for (const std::string& part : section) path += part + "/";
  return model::read_variation(path + name + " = " + std::get<std::string>(values));
}

/// A sweep and its cases.
struct PythonSweep {
  std::vector<SweepCase> cases;
  Sweep sweep;
};

PythonSweep begun(
    const Case& given,
    const std::vector<std::tuple<model::SectionPath, std::string, SweptValues>>& swept,
    const std::string& command) {
  std::vector<model::Variation> variations;
  for (const auto& [section, name, values] : swept)
    variations.push_back(variation_of(given, section, name, values));
  Case named = given;
  if (!named.text.varied_by.empty()) named.text.varied_by = "sweep";
  std::vector<SweepCase> cases = sweep_cases(named, variations);
  Sweep sweep = begun_sweep(given, variations, cases, command);
  return {std::move(cases), std::move(sweep)};
}

py::list points_of(const PythonSweep& found) {
  py::list points;
  for (std::size_t i = 0; i < found.cases.size(); ++i) {
    const post::SweepPoint& point = found.sweep.report.points[i];
    points.append(py::make_tuple(point.values, found.cases[i].given, point.message,
                                 as_list(plain(point.figures)), point.exit_code == 0));
  }
  return points;
}

void bind_sweep(py::module_& module) {
  py::class_<PythonSweep>(module, "Sweep")
      .def_property_readonly("given", [](const PythonSweep& found) { return found.sweep.given; })
      .def_property_readonly("parameters",
                             [](const PythonSweep& found) { return found.sweep.report.parameters; })
      .def("points", points_of)
      .def(
          "numbers",
          [](const PythonSweep& found,
             const std::size_t parameter) -> std::optional<std::vector<double>> {
            const auto values = post::sweep_numbers(found.sweep.report, parameter);
            if (!values) return std::nullopt;
            std::vector<double> numbers;
            for (const post::SweepValue& value : *values) numbers.push_back(value.number);
            return numbers;
          },
          py::arg("parameter"))
      .def("work_out",
           [](PythonSweep& found) {
             const py::gil_scoped_release unlocked;
             work_out(found.sweep, found.cases);
           })
      .def(
          "take",
          [](PythonSweep& found, const std::size_t place, const std::string& summary,
             const std::string& shortfall) {
            constexpr int not_converged = 2;
            post::SweepPoint& point = found.sweep.report.points.at(place);
            point.figures = figures_of_summary(nlohmann::json::parse(summary));
            point.message = shortfall;
            point.exit_code = shortfall.empty() ? 0 : not_converged;
          },
          py::arg("place"), py::arg("summary"), py::arg("shortfall"))
      .def(
          "refuse",
          [](PythonSweep& found, const std::size_t place, const std::string& message) {
            refuse_point(found.sweep.report.points.at(place), message);
          },
          py::arg("place"), py::arg("message"))
      .def("require_figures", [](const PythonSweep& found) { require_figures(found.sweep); })
      .def("table", [](const PythonSweep& found) { return table(found.sweep); })
      .def("document",
           [](const PythonSweep& found) { return post::sweep_summary(found.sweep.report).dump(); })
      .def(
          "write",
          [](const PythonSweep& found, const std::filesystem::path& directory) {
            return as_tuple(write(found.sweep, directory));
          },
          py::arg("directory"));
  module.def("sweep", begun, py::arg("given"), py::arg("swept"), py::arg("command"));
}

void bind_reports(py::module_& module) {
  module.def(
      "write_report",
      [](const std::filesystem::path& results, const std::optional<std::filesystem::path>& file) {
        return as_tuple(write_report(results, file.value_or(results / "report.html")));
      },
      py::arg("results"), py::arg("file"));
}

}  // namespace

}  // namespace geneva::python

PYBIND11_MODULE(_core, module) {
  using namespace geneva::python;
  module.doc() = "Cases and everything that is computed without finite elements.";
  module.attr("version") = geneva::version;
  bind_errors(module);
  bind_units(module);
  bind_case(module);
  bind_kinematics(module);
  bind_estimate(module);
  bind_design(module);
  bind_crown(module);
  bind_synthesis(module);
  bind_optimum(module);
  bind_sweep(module);
  bind_reports(module);
}
