#include "post/view/view_output.h"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/base64.h"
#include "post/analysis/strength_rows.h"
#include "post/analysis/surface_body.h"
#include "post/view/quantised.h"
#include "post/view/view_mesh.h"

namespace geneva::post {

using base::Dimension;
using base::output_unit;
using base::OutputUnit;
using base::UnitSystem;

using dealii::Point;
using dealii::Tensor;
using nlohmann::json;

namespace {

/// Factors from SI to output units, and the place that coordinates are told from: single precision
/// would not resolve a contact far from the origin.
struct ViewScale {
  double length;
  double stress;
  Point<3> origin;  ///< [m]
};

std::vector<float> scaled(const std::vector<float>& values, const double factor) {
  std::vector<float> result;
  for (const float value : values) result.push_back(static_cast<float>(factor * value));
  return result;
}

json quantised_section(const std::vector<float>& values) {
  const Quantised numbers = quantised(values);
  return {{"low", numbers.low}, {"high", numbers.high}, {"steps", base::encoded(numbers.steps)}};
}

json mesh_section(const std::string& name, const std::string& title, const ViewMesh& mesh,
                  const ViewScale& scale) {
  std::vector<float> points;
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    points.push_back(static_cast<float>(
        scale.length * (mesh.points[i] - scale.origin[static_cast<unsigned int>(i % 3)])));
  json fields = json::object();
  for (std::size_t i = 0; i < view_fields.size(); ++i) {
    const auto& values = mesh.fields[i];
    if (std::any_of(values.begin(), values.end(), [](const float x) { return std::isfinite(x); }))
      fields[view_fields[i]] = quantised_section(scaled(values, scale.stress));
  }
  return {
      {"name", name},
      {"title", title},
      {"n_points", mesh.bodies.size()},
      {"n_triangles", mesh.triangles.size() / 3},
      {"points", base::encoded(points)},
      {"displacements", quantised_section(scaled(mesh.displacements, scale.length))},
      {"bodies", base::encoded(std::vector<std::uint8_t>(mesh.bodies.begin(), mesh.bodies.end()))},
      {"triangles", base::encoded(mesh.triangles)},
      {"fields", fields}};
}

template <int dim>
Point<3> in_space(const fem::Components<dim>& place) {
  Point<3> result;
  for (unsigned int i = 0; i < dim; ++i) result[i] = place[i];
  return result;
}

/// Points of one body, to be found by their place.
class PointFinder {
 public:
  PointFinder(const ViewMesh& mesh, const unsigned int body, const double spacing)
      : spacing_(spacing) {
    for (std::size_t i = 0; i < mesh.bodies.size(); ++i)
      if (mesh.bodies[i] == body)
        points_.emplace(key({mesh.points[3 * i], mesh.points[3 * i + 1], mesh.points[3 * i + 2]}),
                        static_cast<unsigned int>(i));
  }

  /// The point at a place; nothing if there is none within the spacing.
  [[nodiscard]] std::optional<unsigned int> at(const Point<3>& place) const {
    const Key middle = key(place);
    for (long i = -1; i <= 1; ++i)
      for (long j = -1; j <= 1; ++j)
        for (long k = -1; k <= 1; ++k) {
          const auto found = points_.find({middle[0] + i, middle[1] + j, middle[2] + k});
          if (found != points_.end()) return found->second;
        }
    return std::nullopt;
  }

 private:
  using Key = std::array<long, 3>;
  [[nodiscard]] Key key(const Point<3>& place) const {
    return {std::lround(place[0] / spacing_), std::lround(place[1] / spacing_),
            std::lround(place[2] / spacing_)};
  }

  double spacing_;
  std::map<Key, unsigned int> points_;
};

/// Where the pressure on the source surface is shown: in 3-D its faces, in the plane a band that
/// is as high as the pressure is great.
struct PressureMesh {
  ViewMesh mesh;
  std::vector<std::size_t> nodes;  ///< contact node of each point
};

void append(const Point<3>& place, const std::size_t node, const std::optional<unsigned int> like,
            const ViewMesh& visible, PressureMesh& result) {
  for (unsigned int i = 0; i < 3; ++i) {
    result.mesh.points.push_back(place[i]);
    result.mesh.displacements.push_back(like ? visible.displacements[3 * *like + i] : 0.F);
  }
  result.mesh.bodies.push_back(like ? visible.bodies[*like] : 0);
  result.nodes.push_back(node);
}

PressureMesh pressure_mesh(const fem::ContactResult<2>& contact, const double width,
                           const ViewMesh& visible, const PointFinder& finder) {
  PressureMesh result;
  const double height = width / contact.peak_pressure;
  for (std::size_t i = 0; i < contact.nodes.size(); ++i) {
    const fem::ContactNode<2>& node = contact.nodes[i];
    const Point<3> foot = in_space<2>(node.position);
    const auto like = finder.at(foot);
    const Point<3> top(foot[0] + height * node.pressure * node.normal[0],
                       foot[1] + height * node.pressure * node.normal[1], 0.);
    append(foot, i, like, visible, result);
    append(top, i, like, visible, result);
  }
  for (unsigned int i = 0; i + 1 < contact.nodes.size(); ++i)
    for (const unsigned int corner : {0U, 2U, 3U, 0U, 3U, 1U})
      result.mesh.triangles.push_back(2 * i + corner);
  return result;
}

PressureMesh pressure_mesh(const fem::ContactResult<3>& contact, const double /*unused*/,
                           const ViewMesh& visible, const PointFinder& finder) {
  PressureMesh result;
  for (std::size_t i = 0; i < contact.nodes.size(); ++i) {
    const Point<3> place = in_space<3>(contact.nodes[i].position);
    append(place, i, finder.at(place), visible, result);
  }
  for (const auto& face : contact.faces)
    for (const std::size_t corner : {0U, 1U, 2U, 0U, 2U, 3U})
      result.mesh.triangles.push_back(static_cast<unsigned int>(face[corner]));
  return result;
}

/// Pressure, and where there is a closed form its difference from Hertz's.
template <int dim>
json pressure_fields(const fem::ContactResult<dim>& contact, const ContactAnalysis<dim>& analysis,
                     const PressureMesh& mesh, const double factor) {
  const auto values = [&](const auto& value_at) {
    std::vector<float> result;
    for (const std::size_t node : mesh.nodes)
      result.push_back(static_cast<float>(factor * value_at(contact.nodes[node])));
    return quantised_section(result);
  };
  using Node = fem::ContactNode<dim>;
  json fields{{"contact_pressure", values([](const Node& node) { return node.pressure; })}};
  if (analysis.hertz)
    fields["hertz_difference"] =
        values([&](const Node& node) { return node.pressure - hertz_pressure(analysis, node); });
  return fields;
}

Point<3> place_of_peak(const fem::ContactResult<2>& /*unused*/,
                       const ContactAnalysis<2>& analysis) {
  return {analysis.centre.place[0], analysis.centre.place[1], 0.};
}
/// The middle of the nodes that carry the maximum pressure of all nodes, which the peak with its
/// correction may exceed, to a thousandth: of a flat contact all.
Point<3> place_of_peak(const fem::ContactResult<3>& contact, const ContactAnalysis<3>& /*unused*/) {
  constexpr double nearly_all = 0.999;
  double maximum = 0.;
  for (const auto& node : contact.nodes) maximum = std::max(maximum, node.pressure);
  Point<3> sum;
  double n_nodes = 0.;
  for (const fem::ContactNode<3>& node : contact.nodes)
    if (node.pressure >= nearly_all * maximum) {
      sum += in_space<3>(node.position);
      ++n_nodes;
    }
  return Point<3>(sum / n_nodes);
}

/// The half-width, or where a single node is in contact a fiftieth of the model.
double shown_half_width(const double half_width, const ViewMesh& visible, const Point<3>& origin) {
  if (half_width > 0.) return half_width;
  double extent = 0.;
  for (std::size_t i = 0; i < visible.points.size(); ++i)
    extent =
        std::max(extent, std::abs(visible.points[i] - origin[static_cast<unsigned int>(i % 3)]));
  return extent / 50.;
}

json vector(const Tensor<1, 3>& of) {
  json list = json::array();
  for (unsigned int i = 0; i < 3; ++i) list.push_back(of[i]);
  return list;
}

/// What is looked at first: the contact with the maximum pressure, or without contact the maximum
/// stress.
struct Focus {
  Point<3> place;     ///< [m]
  double half_width;  ///< a fourth of what a close picture shows to either side [m]; 0: not known
  Tensor<1, 3> normal;
  std::vector<Point<3>> within;  ///< what cuts go through: places of the contact, or of the model
  Tensor<1, 3> along;            ///< normal of the cut across, in 3-D
  Tensor<1, 3> across;           ///< normal of the cut along, in 3-D
  std::string title;             ///< "contact" or "maximum stress"
  std::string maximum;           ///< "where the pressure is greatest"
};

Tensor<1, 3> normal_of(const ContactAnalysis<2>& analysis) {
  return Point<3>(analysis.centre.normal[0], analysis.centre.normal[1], 0.);
}
Tensor<1, 3> normal_of(const ContactAnalysis<3>& analysis) { return analysis.frame.normal; }

void set_axes(Focus& /*unused*/, const ContactAnalysis<2>& /*unused*/) {}
void set_axes(Focus& focus, const ContactAnalysis<3>& analysis) {
  focus.along = analysis.frame.along;
  focus.across = analysis.frame.across;
}

template <int dim>
Focus focus_on(const fem::ContactResult<dim>& contact, const ContactAnalysis<dim>& analysis) {
  Focus focus{place_of_peak(contact, analysis),
              half_width(contact, analysis),
              normal_of(analysis),
              {},
              {},
              {},
              "contact",
              "where the pressure is greatest"};
  set_axes(focus, analysis);
  for (const fem::ContactNode<dim>& node : contact.nodes)
    focus.within.push_back(in_space<dim>(node.position));
  return focus;
}

template <int dim>
Focus focus_on_maximum_stress(const fem::Solution<dim>& solution) {
  Focus focus;
  double maximum = 0.;
  for (const fem::BodyStrength<dim>& body : solution.strength)
    if (body.von_mises.value > maximum) {
      maximum = body.von_mises.value;
      focus.place = in_space<dim>(body.von_mises.place);
    }
  focus.half_width = solution.scales.length / 32.;
  focus.normal = Point<3>(0., 1., 0.);
  focus.along = Point<3>(0., 0., 1.);
  focus.across = Point<3>(1., 0., 0.);
  for (const auto& vertex : solution.mesh.vertices) {
    Point<3> place;
    for (unsigned int i = 0; i < dim; ++i) place[i] = vertex[i];
    focus.within.push_back(place);
  }
  focus.title = "maximum stress";
  focus.maximum = "where the stress is greatest";
  return focus;
}

/// The focus, moved a thousandth of the extent along the normal to where the rest is if the plane
/// through it only touches that: on a plane of symmetry nothing would be cut.
Point<3> within(const Focus& focus, const Tensor<1, 3>& normal) {
  double lowest = 0.;
  double highest = 0.;
  for (const Point<3>& place : focus.within) {
    const double distance = (place - focus.place) * normal;
    lowest = std::min(lowest, distance);
    highest = std::max(highest, distance);
  }
  const double small = 1e-3 * (highest - lowest);
  const double shift = lowest > -small ? small : highest < small ? -small : 0.;
  return focus.place + shift * normal;
}

/// Cuts through the focus.
std::vector<json> cuts(const fem::Solution<2>& /*unused*/, const Results<2>& /*unused*/,
                       const Focus& /*unused*/, const ViewScale& /*unused*/) {
  return {};
}
std::vector<json> cuts(const fem::Solution<3>& solution, const Results<3>& results,
                       const Focus& focus, const ViewScale& scale) {
  std::vector<json> list;
  const std::array<std::pair<const char*, Tensor<1, 3>>, 2> planes{
      {{"across", focus.along}, {"along", focus.across}}};
  for (const auto& [name, normal] : planes) {
    list.push_back(
        mesh_section(name, fmt::format("cut {} the {} {}", name, focus.title, focus.maximum),
                     cut_mesh(solution, results, {within(focus, normal), normal}), scale));
    list.back()["normal"] = vector(normal);
  }
  return list;
}

template <int dim>
json contact_mesh(const fem::Solution<dim>& solution, const fem::ContactResult<dim>& contact,
                  const ContactAnalysis<dim>& analysis, const double width, const ViewMesh& visible,
                  const ViewScale& scale) {
  const PointFinder finder(visible, body_of(solution, contact.source), 1e-4 * width);
  const PressureMesh pressure = pressure_mesh(contact, width, visible, finder);
  json mesh = mesh_section("contact", "contact surface", pressure.mesh, scale);
  mesh["fields"].update(pressure_fields(contact, analysis, pressure, scale.stress));
  return mesh;
}

/// A value > 0 with four digits, without a power of ten where it is large.
std::string with_four_digits(const double value) {
  if (value < 1e4) return fmt::format("{:.4g}", value);
  const double step = std::pow(10., std::floor(std::log10(value)) - 3.);
  return fmt::format("{:.0f}", step * std::round(value / step));
}

/// The places of the bodies' maximum stresses; those that are the same place are one.
template <int dim>
json marks(const fem::Solution<dim>& solution, const ViewScale& scale, const OutputUnit& stress) {
  json list = json::array();
  std::vector<Point<3>> places;
  for (const NamedStress<dim>& named : named_stresses(solution)) {
    const Point<3> place = in_space<dim>(named.maximum.place);
    const std::string title = fmt::format("{} of '{}': {} {}, {}", named.name, named.body,
                                          with_four_digits(named.maximum.value * stress.factor),
                                          stress.name, named.where);
    const auto known = std::find_if(places.begin(), places.end(), [&](const Point<3>& other) {
      return place.distance(other) < 1e-3 * solution.scales.length;
    });
    if (known != places.end()) {
      list.at(static_cast<std::size_t>(known - places.begin())).at("titles").push_back(title);
      continue;
    }
    places.push_back(place);
    list.push_back({{"place", vector(scale.length * (place - scale.origin))}, {"titles", {title}}});
  }
  return list;
}

/// The contact with the maximum pressure; nothing without contact.
template <int dim>
std::optional<std::size_t> contact_in_view(const fem::Solution<dim>& solution) {
  return fem::has_contact(solution.problem) ? std::optional(leading_contact(solution))
                                            : std::nullopt;
}

}  // namespace

template <int dim>
json view_document(const fem::Solution<dim>& solution, const Results<dim>& results,
                   const UnitSystem units) {
  const std::optional<std::size_t> leading = contact_in_view(solution);
  if (leading && solution.contacts[*leading].peak_pressure <= 0.) return nullptr;
  const Focus focus = leading ? focus_on(solution.contacts[*leading], results.contacts[*leading])
                              : focus_on_maximum_stress(solution);
  const OutputUnit length = output_unit(units, Dimension::length);
  const OutputUnit stress = output_unit(units, Dimension::stress);
  const ViewScale scale{length.factor, stress.factor, focus.place};
  const ViewMesh visible = visible_mesh(solution, results);
  json meshes = json::array();
  meshes.push_back(mesh_section("model", "whole model", visible, scale));
  for (json& cut : cuts(solution, results, focus, scale)) meshes.push_back(std::move(cut));
  if (dealii::Utilities::MPI::this_mpi_process(solution.dof_handler->get_communicator()) != 0)
    return nullptr;

  const double width = shown_half_width(focus.half_width, visible, scale.origin);
  if (leading)
    meshes.push_back(contact_mesh(solution, solution.contacts[*leading], results.contacts[*leading],
                                  width, visible, scale));
  json bodies = json::array();
  for (const fem::Body<dim>& body : solution.problem.bodies) bodies.push_back(body.name);
  json view = json::object();
  view["dimension"] = dim;
  view["focus"] = focus.title;
  view["length_unit"] = length.name;
  view["stress_unit"] = stress.name;
  view["origin"] = vector(scale.length * scale.origin);
  view["half_width"] = scale.length * width;
  view["normal"] = vector(focus.normal);
  view["marks"] = marks(solution, scale, stress);
  view["bodies"] = std::move(bodies);
  view["outlines"] = base::encoded(visible.outlines);
  view["meshes"] = std::move(meshes);
  return view;
}

template json view_document(const fem::Solution<2>&, const Results<2>&, UnitSystem);
template json view_document(const fem::Solution<3>&, const Results<3>&, UnitSystem);

}  // namespace geneva::post
