#include "post/analysis/figures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fem/adaptivity/error_estimate.h"
#include "fem/adaptivity/force_error.h"

namespace geneva::post {

namespace {

/// The cells at a contact, and what is fitted to them.
struct ContactCells {
  double size;            ///< over the half-width
  double size_in_middle;  ///< of the length, over the half-width there
  bool is_axisymmetric;
  bool is_elliptic;  ///< the pressure is spread as Hertz's: p^2 is a parabola
};

/// Mean square of the distances from the centre of pressure over that of the half-width: 1/4 of
/// Hertz's line, 2/5 of his circle.
bool is_elliptic(const fem::Solution<2>& solution, const fem::ContactResult<2>& contact,
                 const bool is_axisymmetric) {
  constexpr double near = 0.05;
  const double centre = pressure_centre(solution, contact).arc_length;
  double force = 0.;
  double square = 0.;
  for (const fem::ContactNode<2>& node : contact.nodes) {
    const double share = node.pressure * node.tributary;
    force += share;
    square += share * std::pow((node.arc_length - centre) / contact.half_width, 2);
  }
  return force > 0. && std::abs(square / force / (is_axisymmetric ? 0.4 : 0.25) - 1.) < near;
}

/// The size is the mean distance of the nodes in contact.
ContactCells contact_cells(const fem::Solution<2>& solution, const fem::ContactResult<2>& contact) {
  double length = 0.;
  for (const fem::ContactInterval& interval : contact.intervals)
    length += interval.end - interval.begin;
  const bool is_axisymmetric = solution.problem.plane == fem::PlaneKind::axisymmetric;
  const double size = length / contact.active_nodes / contact.half_width;
  return {size, size, is_axisymmetric, is_elliptic(solution, contact, is_axisymmetric)};
}

/// Where a bent or tilted pin presses beside the middle, fewer nodes lie across it there.
ContactCells contact_cells(const fem::Solution<3>& solution, const fem::ContactResult<3>& contact) {
  const auto across = static_cast<double>(solution.history.back().nodes_across);
  const ContactFrame frame = contact_frame(solution, contact);
  const bool is_along_z = std::abs(frame.along * z_axis) > 1. - 1e-6;
  const auto in_middle = static_cast<double>(is_along_z ? nodes_across_middle(contact, frame) : 0);
  return {2. / across, 2. / (in_middle > 0. ? std::min(in_middle, across) : across), false, true};
}

/// What the nodes and cells leave open that a figure is taken from, with cells of the size s times
/// the half-width: first s + the lesser of second s^2 and most s. Only meshes with eight nodes
/// across the contact can be compared where something `is_fitted`.
struct Evaluation {
  double first;
  double second;
  bool is_fitted;
  double most = std::numeric_limits<double>::infinity();

  [[nodiscard]] double open(const double size) const {
    return size * (first + std::min(second * size, most));
  }
};

/// Measured on random line contacts, wheels, spheres and punches at 0.5 %, s from 0.02 to 0.11,
/// beyond what the cells around leave: half-widths are off by up to 1.9 s^2, where p^2 is no
/// parabola by 0.5 s; the maximum shear by 2 s^2; its depth by 0.14 s, of spheres by 1.5 s and
/// of punches by 1.8 s; the tension of a surface that slides with mu = 0.1 by up to 1.5 s. In 3-D
/// the depth is that of a cell's middle, which 0.7 of a cell was seen to be off. With s from 0.14
/// to 0.22 half-widths of Hertz's pressure were off by up to 0.13 s, the maximum shear by 0.2 s; in
/// 3-D with s up to 0.29 by 0.1 s and 0.25 s.
Evaluation evaluation(const Figure figure, const ContactCells& cells, const int dim) {
  const auto of_ellipse = [&](const double most) {
    return cells.is_elliptic ? most : std::numeric_limits<double>::infinity();
  };
  switch (figure) {
    case Figure::half_width:
    case Figure::half_length:
      return {cells.is_elliptic ? 0. : 1., 2., true, of_ellipse(0.15)};
    case Figure::max_shear:
    case Figure::mid_length_shear:
      return {0., 2.5, true, of_ellipse(dim == 2 ? 0.25 : 0.4)};
    case Figure::max_shear_depth:
    case Figure::mid_length_shear_depth:
      if (dim == 3) return {0.9, 0., true};
      return {!cells.is_elliptic ? 2. : cells.is_axisymmetric ? 1.6 : 0.15, 0., true};
    case Figure::mid_length_pressure:
      return {0., 0.2, true};
    case Figure::surface_tension:
      return {1.5, 0., true};
    default:
      return {0., 0., false};
  }
}

bool is_depth(const Figure figure) {
  return figure == Figure::max_shear_depth || figure == Figure::mid_length_shear_depth;
}

bool is_of_middle(const Figure figure) {
  return Figure::mid_length_pressure <= figure && figure <= Figure::line_load_middle;
}

/// Whether a figure follows from the balance of forces or from the bodies as a whole, not from the
/// stress around the contact.
bool is_global(const Figure figure) {
  return figure == Figure::force || figure >= Figure::bore_torque;
}

/// Of the pin as a whole: all cells around count alike, wherever they are, and not by their
/// distance from the contact.
bool is_of_bending(const Figure figure) {
  return figure == Figure::tip_deflection || figure == Figure::slope ||
         figure == Figure::root_stress;
}

/// What cells of the size gamma times their distance from the contact leave open of a pin's
/// bending, over gamma: of the first order, since its root is clamped. Measured on random pins with
/// one cell in the free length, 0.2 to 0.9 of the diameter long: deflection and slope off by up to
/// 0.26, the stress by up to 0.16.
double bending_coefficient(const Figure figure) {
  return figure == Figure::root_stress ? 0.15 : is_of_bending(figure) ? 0.25 : 0.;
}

/// A figure on the meshes that have it.
struct Course {
  std::vector<fem::MeshValue> values;
  std::vector<unsigned int> nodes_across;
};

/// How a figure goes with the contact's force: as Hertz's lengths and stresses do, at most. A depth
/// has its part from the half-width.
fem::ForcePower force_of(const Figure figure) {
  const bool is_of_contact = figure < Figure::bore_torque && !is_depth(figure);
  return {figure == Figure::force ? 1. : is_of_contact ? 0.5 : 0., 0.};
}

template <typename OnMesh>
Course course_of(const std::vector<fem::LevelRecord>& history, const Figure figure,
                 const OnMesh& on_mesh) {
  Course course;
  for (std::size_t mesh = 0; mesh < history.size(); ++mesh) {
    const double value = value_of(on_mesh(mesh), figure).value_or(0.);
    if (value == 0.) continue;
    const fem::LevelRecord& record = history[mesh];
    course.values.push_back(
        {fem::under_true_force(value, record.energy_error, force_of(figure)), record.refined,
         record.halvings,
         is_of_bending(figure) ? record.grading * record.grading : record.size_measure,
         record.energy_error});
    course.nodes_across.push_back(record.nodes_across);
  }
  return course;
}

/// What the last refinement of the zone between two resolved meshes leaves at second order,
/// relative; 0 if there was none.
double left_at_second_order(const Course& course) {
  constexpr unsigned int resolved = 8;
  for (std::size_t i = course.values.size(); i-- > 1;) {
    const fem::MeshValue& now = course.values[i];
    if (now.refined != fem::Refined::zone) continue;
    if (course.nodes_across[i - 1] < resolved) return 0.;
    return std::abs(1. - course.values[i - 1].value / now.value) /
           (std::pow(4., now.halvings) - 1.);
  }
  return 0.;
}

double error_of(const Course& course, const Figure figure, const double grading,
                const bool force_is_known, const ContactCells& cells, const int dim) {
  // What the conjugate gradients leave of a force that the loads decide.
  constexpr double solver_tolerance = 1e-7;
  const Evaluation own = evaluation(figure, cells, dim);
  const double size = is_of_middle(figure) ? cells.size_in_middle : cells.size;
  // Then too few nodes and cells carry a parabola or a cubic; of Hertz's, fewer than eight.
  const double coarse = cells.is_elliptic ? 0.26 : 0.17;
  const double unfitted = dim == 2 && own.is_fitted && size > coarse ? 0.5 * size : 0.;
  const double open = own.open(size) + unfitted;
  if (is_depth(figure)) return open;
  const fem::Extrapolation found =
      fem::extrapolate(course.values, grading, {force_is_known, false, false});
  const double zone = own.is_fitted && course.values.size() > 1
                          ? std::max(open, left_at_second_order(course))
                          : found.zone_error;
  return zone + std::abs(found.correction) + found.surroundings_error + solver_tolerance;
}

/// The figures are those of the mesh, under a force that is too great.
double by_force(const double energy_error, const Figure figure) {
  const fem::ForcePower force = force_of(figure);
  return 1. - fem::under_true_force(1., energy_error, force) +
         fem::open_by_force(energy_error, force);
}

/// Of the figures on the last mesh. A depth is that of a shear field as wide as the contact: it has
/// the half-width's error beside its own.
/// @param on_mesh figures by the number of the mesh
template <int dim, typename OnMesh>
Figures errors_of(const fem::Solution<dim>& solution, const ContactCells& cells,
                  const OnMesh& on_mesh) {
  const auto& history = solution.history;
  const bool force_is_known = fem::force_is_known(solution.problem);
  Figures errors;
  for (const auto& [figure, value] : on_mesh(history.size() - 1)) {
    if (value == 0.) continue;
    const bool is_local = solution.has_free_ends && !is_global(figure);
    errors[figure] = error_of(course_of(history, figure, on_mesh), figure,
                              is_local ? history.back().grading : 0., force_is_known, cells, dim);
    errors[figure] += by_force(history.back().energy_error, figure);
  }
  const double of_width = value_of(errors, Figure::half_width).value_or(0.);
  for (auto& [figure, error] : errors) {
    if (is_depth(figure)) error += of_width;
    error += bending_coefficient(figure) * history.back().grading;
  }
  return errors;
}

/// A pin whose section is meshed with a smaller second moment of area bends by that much more.
void add_section_error(Figures& errors, const double section_moment) {
  for (const Figure figure : {Figure::tip_deflection, Figure::slope, Figure::root_stress})
    errors[figure] += std::abs(1. - section_moment);
  errors.erase(Figure::section_moment);
}

}  // namespace

std::optional<double> value_of(const Figures& figures, const Figure figure) {
  const auto found = figures.find(figure);
  return found == figures.end() ? std::nullopt : std::optional(found->second);
}

Figures figures(const fem::ContactResult<2>& contact, const ContactAnalysis<2>& analysis) {
  Figures all{{Figure::force, fem::magnitude(contact.force)},
              {Figure::half_width, contact.half_width},
              {Figure::max_shear, analysis.max_shear.value},
              {Figure::max_shear_depth, analysis.max_shear_depth}};
  if (analysis.surface) all[Figure::surface_tension] = analysis.surface->tension;
  return all;
}

Figures figures(const fem::ContactResult<3>& contact, const ContactAnalysis<3>& analysis) {
  Figures all{{Figure::force, fem::magnitude(contact.force)},
              {Figure::half_width, analysis.half_width},
              {Figure::half_length, analysis.half_length},
              {Figure::max_shear, analysis.max_shear},
              {Figure::max_shear_depth, analysis.max_shear_depth}};
  if (analysis.sections.empty()) return all;
  const ContactSection middle = middle_section(contact, analysis.frame, analysis.sections);
  const LineLoad load = line_load(contact, analysis.frame, analysis.sections);
  all[Figure::mid_length_pressure] = middle.peak_pressure;
  all[Figure::mid_length_shear] = middle.max_shear;
  all[Figure::mid_length_shear_depth] = middle.max_shear_depth;
  all[Figure::line_load_middle] = load.middle;
  all[Figure::line_load_end] = load.end;
  return all;
}

template <int dim>
RunFigures contact_figures(const fem::Solution<dim>& solution,
                           const std::vector<CellStress<dim>>& cells) {
  RunFigures run;
  for (const fem::ContactResult<dim>& contact : solution.contacts)
    run.contacts.push_back(figures(contact, contact_analysis(solution, contact, cells)));
  return run;
}

template <int dim>
RunFigures figure_errors(const fem::Solution<dim>& solution,
                         const std::vector<RunFigures>& meshes) {
  RunFigures errors;
  for (std::size_t i = 0; i < solution.contacts.size(); ++i) {
    const ContactCells cells = contact_cells(solution, solution.contacts[i]);
    errors.contacts.push_back(errors_of(
        solution, cells,
        [&](const std::size_t mesh) -> const Figures& { return meshes[mesh].contacts[i]; }));
  }
  // Of that pressure the run's own estimate speaks then.
  if (solution.edge && !solution.edge->is_bounded)
    for (Figures& contact : errors.contacts)
      contact[Figure::mid_length_pressure] = solution.error_estimate;
  errors.mechanism =
      errors_of(solution, ContactCells{},
                [&](const std::size_t mesh) -> const Figures& { return meshes[mesh].mechanism; });
  if (const auto moment = value_of(meshes.back().mechanism, Figure::section_moment))
    add_section_error(errors.mechanism, *moment);
  return errors;
}

template RunFigures figure_errors(const fem::Solution<2>&, const std::vector<RunFigures>&);
template RunFigures figure_errors(const fem::Solution<3>&, const std::vector<RunFigures>&);
template RunFigures contact_figures(const fem::Solution<2>&, const std::vector<CellStress<2>>&);
template RunFigures contact_figures(const fem::Solution<3>&, const std::vector<CellStress<3>>&);

}  // namespace geneva::post
