#include <mpi.h>
#include <pybind11/stl/filesystem.h>

#include <array>
#include <functional>
#include <memory>
#include <set>

#include "api/analysis.h"
#include "api/crown_confirmation.h"
#include "api/cycle.h"
#include "api/design_strength.h"
#include "api/load_history.h"
#include "api/optimum_confirmation.h"
#include "api/session.h"
#include "api/told_together.h"
#include "python/bindings.h"

namespace geneva::python {

namespace {

using base::Dimension;

/// An analysis whose solution can be let go before MPI ends, which frees its communicators.
class SolvedCase {
 public:
  explicit SolvedCase(Analysis found) : analysis(std::move(found)) { living().insert(this); }
  ~SolvedCase() { living().erase(this); }
  SolvedCase(const SolvedCase&) = delete;
  SolvedCase& operator=(const SolvedCase&) = delete;

  /// Of all that are left where the interpreter ends.
  static void let_go() {
    for (SolvedCase* const solved : living()) solved->analysis.state.reset();
  }

  Analysis analysis;

 private:
  static std::set<SolvedCase*>& living() {
    static std::set<SolvedCase*> all;
    return all;
  }
};

/// MPI and the libraries of the solver, from the first analysis to the end of the interpreter.
class LazySession {
 public:
  static void start() {
    if (session()) return;
    static std::array<char, 7> name{'p', 'y', 't', 'h', 'o', 'n', '\0'};
    static std::array<char*, 2> arguments{name.data(), nullptr};
    int count = 1;
    char** values = arguments.data();
    session() = std::make_unique<Session>(count, values);
  }
  static void end() {
    SolvedCase::let_go();
    session().reset();
  }

 private:
  static std::unique_ptr<Session>& session() {
    static std::unique_ptr<Session> started;
    return started;
  }
};

std::string library_version() {
  std::array<char, MPI_MAX_LIBRARY_VERSION_STRING> text{};
  int length = 0;
  MPI_Get_library_version(text.data(), &length);
  return {text.data(), static_cast<std::size_t>(length)};
}

/// The communicator of an object of mpi4py; of None that of this process alone.
/// @throws InputError if mpi4py is built with another MPI than Geneva
MPI_Comm communicator_of(const py::object& communicator) {
  LazySession::start();
  if (communicator.is_none()) return MPI_COMM_SELF;
  if (!py::hasattr(communicator, "py2f"))
    throw py::type_error("comm: a communicator of mpi4py is wanted, such as MPI.COMM_WORLD");
  const auto theirs =
      py::module_::import("mpi4py.MPI").attr("Get_library_version")().cast<std::string>();
  if (theirs != library_version())
    throw InputError("comm: mpi4py was built with another MPI (" + theirs + ") than geneva (" +
                     library_version() + "): install Debian's python3-mpi4py");
  return MPI_Comm_f2c(communicator.attr("py2f")().cast<MPI_Fint>());
}

py::dict as_dict(const fem::LevelRecord& mesh) {
  py::dict dict;
  dict["cells"] = mesh.cells;
  dict["unknowns"] = mesh.dofs;
  dict["peak_pressure"] = mesh.peak_pressure;
  dict["error"] = mesh.error_estimate;
  dict["active_nodes"] = mesh.active_nodes;
  dict["linear_iterations"] = mesh.linear_iterations;
  dict["seconds"] = mesh.seconds;
  return dict;
}

py::dict as_dict(const fem::StepReport& step) {
  py::dict dict;
  dict["mesh"] = step.level;
  dict["unknowns"] = step.dofs;
  dict["step"] = step.step;
  dict["linear_iterations"] = step.linear_iterations;
  return dict;
}

std::vector<PlainFigure> plain(const std::vector<post::ComparisonRow>& rows) {
  std::vector<PlainFigure> figures;
  for (const post::ComparisonRow& row : rows) {
    PlainFigure figure{row.quantity, row.dimension, row.computed, row.error};
    figure.closed_form = row.closed_form;
    figure.published = row.published;
    figure.is_bounded = row.is_bounded;
    figures.push_back(figure);
  }
  return figures;
}

/// Tells Python of meshes and steps, which the tellers must outlive.
Progress progress_of(Teller& meshes, Teller& steps) {
  Progress progress;
  progress.mesh = [&meshes](const fem::LevelRecord& mesh) {
    const py::gil_scoped_acquire lock;
    meshes.tell(as_dict(mesh));
  };
  progress.step = [&steps](const fem::StepReport& step) {
    const py::gil_scoped_acquire lock;
    steps.tell(as_dict(step));
  };
  return progress;
}

std::unique_ptr<SolvedCase> run(const Case& given, const py::object& comm,
                                const py::object& progress, const py::object& on_step) {
  const MPI_Comm communicator = communicator_of(comm);
  Teller meshes(progress);
  Teller steps(on_step);
  AnalysisOptions options;
  options.progress = progress_of(meshes, steps);
  return meshes.compute([&] {
    return steps.rethrowing(
        [&] { return std::make_unique<SolvedCase>(analyse(given, communicator, options)); });
  });
}

LoadHistory load_steps(const Case& given, const py::object& comm, const py::object& progress,
                       const py::object& on_step) {
  const MPI_Comm communicator = communicator_of(comm);
  Teller meshes(progress);
  Teller steps(on_step);
  const Progress told = progress_of(meshes, steps);
  return meshes.compute([&] {
    return steps.rethrowing([&] { return load_history(given, communicator, nullptr, told); });
  });
}

py::dict as_dict(const Contact& contact) {
  std::vector<Vector> places;
  for (const ContactPoint& point : contact.points) places.push_back(point.place);
  py::dict dict;
  dict["source"] = contact.source;
  dict["target"] = contact.target;
  dict["force"] = py::array_t<double>(3, contact.force.data());
  dict["peak_pressure"] = contact.peak_pressure;
  dict["half_width"] = contact.half_width;
  dict["place"] = matrix(places);
  dict["pressure"] =
      column(contact.points, [](const ContactPoint& point) { return point.pressure; });
  dict["gap"] = column(contact.points, [](const ContactPoint& point) { return point.gap; });
  dict["hertz_pressure"] =
      column(contact.points, [](const ContactPoint& point) { return point.hertz_pressure; });
  return dict;
}

py::list contacts_of(const SolvedCase& solved) {
  py::list list;
  for (const Contact& contact : solved.analysis.contacts) list.append(as_dict(contact));
  return list;
}

py::list meshes_of(const SolvedCase& solved) {
  py::list list;
  for (const fem::LevelRecord& mesh : solved.analysis.meshes) list.append(as_dict(mesh));
  return list;
}

py::list checks_of(const SolvedCase& solved) {
  py::list list;
  for (const post::Check& check : solved.analysis.checks)
    list.append(py::make_tuple(check.name, check.meaning, check.value, check.limit));
  return list;
}

/// Cells as rows of the indices of their nodes.
py::array_t<long> cells_of(const Fields& fields) {
  const std::size_t nodes = fields.cells.empty() ? 4 : fields.cells.front().size();
  py::array_t<long> array({fields.cells.size(), nodes});
  auto values = array.mutable_unchecked<2>();
  for (std::size_t i = 0; i < fields.cells.size(); ++i)
    for (std::size_t j = 0; j < nodes; ++j)
      values(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(j)) =
          static_cast<long>(fields.cells[i][j]);
  return array;
}

py::dict as_dict(const Fields& fields) {
  py::dict dict;
  dict["place"] = matrix(fields.places);
  dict["displacement"] = matrix(fields.displacements);
  dict["stress"] = matrix(fields.stress);
  dict["von_mises"] = column(fields.von_mises, [](const double value) { return value; });
  dict["cells"] = cells_of(fields);
  dict["bodies"] = py::array_t<unsigned int>(static_cast<py::ssize_t>(fields.bodies.size()),
                                             fields.bodies.data());
  return dict;
}

void bind_analysis(py::module_& module) {
  py::class_<SolvedCase>(module, "Analysis")
      .def_property_readonly("given", [](const SolvedCase& one) { return one.analysis.given; })
      .def_property_readonly("is_converged",
                             [](const SolvedCase& one) { return one.analysis.is_converged; })
      .def_property_readonly("shortfall",
                             [](const SolvedCase& one) { return one.analysis.shortfall; })
      .def_property_readonly("error", [](const SolvedCase& one) { return one.analysis.error; })
      .def_property_readonly("memory", [](const SolvedCase& one) { return one.analysis.memory; })
      .def_property_readonly("notices", [](const SolvedCase& one) { return one.analysis.notices; })
      .def("table", [](const SolvedCase& one) { return one.analysis.table; })
      .def("document", [](const SolvedCase& one) { return summary(one.analysis).dump(); })
      .def("figures", [](const SolvedCase& one) { return as_list(plain(one.analysis.figures)); })
      .def("contacts", contacts_of)
      .def("meshes", meshes_of)
      .def("checks", checks_of)
      .def("fields", [](const SolvedCase& one) { return as_dict(fields(one.analysis)); })
      .def(
          "write",
          [](const SolvedCase& one, const std::filesystem::path& directory) {
            Written written;
            {
              const py::gil_scoped_release unlocked;
              written = write(one.analysis, directory);
            }
            return as_tuple(written);
          },
          py::arg("directory"));
  module.def("run", run, py::arg("given"), py::arg("comm"), py::arg("progress"),
             py::arg("on_step"));
}

double of_contact(const post::CyclePoint& point, double post::CycleContact::*const figure) {
  return point.contact ? (*point.contact).*figure : std::numeric_limits<double>::quiet_NaN();
}

py::dict instants_of(const Cycle& found) {
  using Point = post::CyclePoint;
  const auto& points = found.report.points;
  Columns columns;
  columns.add("time", Dimension::time, points,
              [](const Point& point) { return point.instant.load.time; });
  columns.add("driver angle", Dimension::angle, points,
              [](const Point& point) { return point.instant.load.driver_angle; });
  columns.add("pin force", Dimension::force, points,
              [](const Point& point) { return point.instant.load.force; });
  columns.add("Hertz pressure", Dimension::stress, points,
              [](const Point& point) { return point.hertz_pressure; });
  columns.add("peak pressure", Dimension::stress, points, [](const Point& point) {
    return of_contact(point, &post::CycleContact::peak_pressure);
  });
  columns.add("error", Dimension::dimensionless, points,
              [](const Point& point) { return of_contact(point, &post::CycleContact::error); });
  columns.add("half-width", Dimension::length, points, [](const Point& point) {
    return of_contact(point, &post::CycleContact::half_width);
  });
  return columns.dict();
}

py::dict curves_of(const Cycle& found) {
  using Point = post::CycleCurvePoint;
  const auto& points = found.report.curve;
  Columns columns;
  columns.add("driver angle", Dimension::angle, points,
              [](const Point& point) { return point.driver_angle; });
  columns.add("pin force", Dimension::force, points,
              [](const Point& point) { return point.force; });
  columns.add("Hertz pressure", Dimension::stress, points,
              [](const Point& point) { return point.hertz_pressure; });
  columns.add("peak pressure", Dimension::stress, points,
              [](const Point& point) { return point.peak_pressure; });
  columns.add("slip speed", Dimension::speed, points,
              [](const Point& point) { return point.slip_speed; });
  columns.add("pin distance", Dimension::length, points,
              [](const Point& point) { return point.pin_distance; });
  return columns.dict();
}

py::list refusals_of(const Cycle& found) {
  py::list list;
  for (const post::CyclePoint& point : found.report.points) list.append(point.refusal);
  return list;
}

py::dict contact_over_steps(const LoadHistory& found, const std::size_t pair) {
  using Point = post::LoadStepPoint;
  const auto& points = found.report.steps;
  Columns columns;
  const auto add = [&](const char* const name, const Dimension dimension, const auto& of_contact) {
    columns.add(name, dimension, points,
                [&](const Point& point) { return of_contact(point.contacts[pair]); });
  };
  using Contact = post::ContactAtStep;
  columns.add("time", Dimension::time, points, [](const Point& point) { return point.time; });
  constexpr std::array<const char*, 3> forces{"force x", "force y", "force z"};
  constexpr std::array<const char*, 3> frictions{"friction force x", "friction force y",
                                                 "friction force z"};
  for (std::size_t i = 0; i < 3; ++i) {
    add(forces[i], Dimension::force, [i](const Contact& contact) { return contact.force[i]; });
    add(frictions[i], Dimension::force,
        [i](const Contact& contact) { return contact.friction_force[i]; });
  }
  add("peak pressure", Dimension::stress,
      [](const Contact& contact) { return contact.peak_pressure; });
  add("half-width", Dimension::length, [](const Contact& contact) { return contact.half_width; });
  add("change from the mesh before", Dimension::dimensionless, [](const Contact& contact) {
    return contact.change.value_or(std::numeric_limits<double>::quiet_NaN());
  });
  add("sticking nodes", Dimension::dimensionless,
      [](const Contact& contact) { return static_cast<double>(contact.sticking); });
  add("slipping nodes", Dimension::dimensionless,
      [](const Contact& contact) { return static_cast<double>(contact.slipping); });
  add("heat of friction", Dimension::moment,  // N m
      [](const Contact& contact) { return contact.dissipated; });
  return columns.dict();
}

py::dict contacts_over_steps(const LoadHistory& found) {
  py::dict dict;
  const auto& contacts = found.report.steps.front().contacts;
  for (std::size_t i = 0; i < contacts.size(); ++i)
    dict[py::str(contacts[i].source + " -> " + contacts[i].target)] = contact_over_steps(found, i);
  return dict;
}

py::dict stresses_over_steps(const LoadHistory& found) {
  using Point = post::LoadStepPoint;
  const auto& points = found.report.steps;
  py::dict dict;
  for (std::size_t i = 0; i < points.front().stresses.size(); ++i) {
    Columns columns;
    columns.add("von Mises", Dimension::stress, points,
                [i](const Point& point) { return point.stresses[i].von_mises; });
    columns.add("first principal", Dimension::stress, points,
                [i](const Point& point) { return point.stresses[i].first_principal; });
    dict[py::str(points.front().stresses[i].body)] = columns.dict();
  }
  return dict;
}

template <typename Found>
py::list fields_of(const Found& found) {
  py::list list;
  for (const post::CycleFields& instant : found.fields) list.append(as_dict(instant.fields));
  return list;
}

template <typename Found>
std::vector<PlainFigure> limits_of(const Found& found) {
  std::vector<PlainFigure> figures;
  for (const post::LimitRow& row : found.report.limits) {
    PlainFigure figure{row.quantity, row.dimension, row.value};
    figure.limit = row.allowed;
    figure.driver_angle = row.driver_angle;
    figure.note = row.meaning;
    figures.push_back(figure);
  }
  return figures;
}

void bind_load_steps(py::module_& module) {
  bind_result<LoadHistory>(module, "LoadHistory")
      .def_readonly("is_converged", &LoadHistory::is_converged)
      .def_property_readonly("notices",
                             [](const LoadHistory& found) { return found.report.notices; })
      .def_property_readonly("error", [](const LoadHistory& found) { return found.report.error; })
      .def("table", [](const LoadHistory& found) { return table(found); })
      .def("document",
           [](const LoadHistory& found) { return post::load_history_summary(found.report).dump(); })
      .def("limits", [](const LoadHistory& found) { return as_list(limits_of(found)); })
      .def("contacts", contacts_over_steps)
      .def("stresses", stresses_over_steps)
      .def("fields", fields_of<LoadHistory>);
  module.def("load_steps", load_steps, py::arg("given"), py::arg("comm"), py::arg("progress"),
             py::arg("on_step"));
}

void bind_cycle(py::module_& module) {
  bind_result<Cycle>(module, "Cycle")
      .def_readonly("is_converged", &Cycle::is_converged)
      .def_property_readonly("notices", [](const Cycle& found) { return found.report.notices; })
      .def("table", [](const Cycle& found) { return table(found); })
      .def("document", [](const Cycle& found) { return post::cycle_summary(found.report).dump(); })
      .def("limits", [](const Cycle& found) { return as_list(limits_of(found)); })
      .def("instants", instants_of)
      .def("curves", curves_of)
      .def("refusals", refusals_of)
      .def("fields", fields_of<Cycle>);
  module.def(
      "cycle",
      [](const Case& given, const py::object& comm, const py::object& progress) {
        const MPI_Comm communicator = communicator_of(comm);
        Teller teller(progress);
        return teller.compute([&] {
          return cycle(
              given, communicator, nullptr,
              [&](const post::CyclePoint& point, const std::size_t done, const std::size_t of) {
                teller.tell(done, of, post::instant_in_words(point.instant));
              });
        });
      },
      py::arg("given"), py::arg("comm"), py::arg("progress"));
}

Optimum optimum_of(const Case& given, const py::object& comm, const py::object& progress) {
  const MPI_Comm communicator = communicator_of(comm);
  Teller teller(progress);
  const std::function<void(int)> tell = [&](const int trials) { teller.tell(trials); };
  return teller.compute([&] {
    return optimise(
        given, [&](const Case& wheel) { return slot_bottom_stress(wheel, communicator); },
        told_together(communicator, tell));
  });
}

void bind_confirmations(py::module_& module) {
  module.def(
      "add_strength",
      [](Design& design, const py::object& comm, const py::object& progress) {
        const MPI_Comm communicator = communicator_of(comm);
        Teller teller(progress);
        teller.compute([&] {
          add_strength(design, communicator, nullptr,
                       [&](const int done, const int of) { teller.tell(done, of); });
        });
      },
      py::arg("design"), py::arg("comm"), py::arg("progress"));
  module.def(
      "confirm_crown",
      [](Crown& crown, const py::object& comm) {
        const MPI_Comm communicator = communicator_of(comm);
        const py::gil_scoped_release unlocked;
        return confirm(crown, communicator);
      },
      py::arg("crown"), py::arg("comm"));
  module.def("optimise", optimum_of, py::arg("given"), py::arg("comm"), py::arg("progress"));
  module.def(
      "confirm_optimum",
      [](Optimum& optimum, const py::object& comm) {
        const MPI_Comm communicator = communicator_of(comm);
        const py::gil_scoped_release unlocked;
        return confirm(optimum, communicator);
      },
      py::arg("optimum"), py::arg("comm"));
}

}  // namespace

}  // namespace geneva::python

PYBIND11_MODULE(_solver, module) {
  using namespace geneva::python;
  module.doc() = "Analyses of the contact by finite elements.";
  // its types and errors
  static PyObject* const ended = py::module_::import("geneva._core")
                                     .attr("EndedByOtherRank")
                                     .cast<py::object>()
                                     .release()
                                     .ptr();
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const geneva::EndedByOtherRank& error) {
      PyErr_SetString(ended, error.what());
    }
  });
  bind_analysis(module);
  bind_cycle(module);
  bind_load_steps(module);
  bind_confirmations(module);
  py::module_::import("atexit").attr("register")(py::cpp_function(LazySession::end));
}
