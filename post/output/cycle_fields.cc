#include "post/output/cycle_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "base/base64.h"

namespace geneva::post {

using base::Dimension;
using base::OutputUnit;

namespace {

namespace bg = boost::geometry;
using Place = std::array<double, 3>;
using BoostPoint = bg::model::point<double, 3, bg::cs::cartesian>;
using Box = bg::model::box<BoostPoint>;

BoostPoint point_of(const Place& place) { return {place[0], place[1], place[2]}; }

/// Stress between the nodes of one instant.
class StressAt {
 public:
  explicit StressAt(const NodalFields& fields) : fields_(fields) {
    std::vector<std::pair<Box, std::size_t>> boxes;
    for (std::size_t cell = 0; cell < fields.cells.size(); ++cell)
      boxes.emplace_back(box_of(cell), cell);
    tree_ = Tree(boxes.begin(), boxes.end());
  }

  /// In the cell of a body that has the place, or is nearest to it.
  [[nodiscard]] std::array<double, 6> operator()(const Place& place,
                                                 const unsigned int body) const {
    constexpr unsigned int nearest_cells = 12;
    std::vector<std::pair<Box, std::size_t>> near;
    tree_.query(bg::index::nearest(point_of(place), nearest_cells) &&
                    bg::index::satisfies([&](const std::pair<Box, std::size_t>& value) {
                      return fields_.bodies[value.second] == body;
                    }),
                std::back_inserter(near));
    double least = std::numeric_limits<double>::max();
    std::array<double, 6> stress{};
    for (const auto& [box, cell] : near) {
      const std::vector<double> weights = clamped_weights(cell, place);
      const double distance = distance_to(cell, weights, place);
      if (distance >= least) continue;
      least = distance;
      stress = {};
      for (std::size_t corner = 0; corner < weights.size(); ++corner)
        for (std::size_t i = 0; i < 6; ++i)
          stress[i] += weights[corner] * fields_.stress[fields_.cells[cell][corner]][i];
    }
    return stress;
  }

 private:
  using Tree = bg::index::rtree<std::pair<Box, std::size_t>, bg::index::quadratic<16>>;

  [[nodiscard]] Box box_of(const std::size_t cell) const {
    Place low;
    Place high;
    low.fill(std::numeric_limits<double>::max());
    high.fill(std::numeric_limits<double>::lowest());
    for (const std::size_t node : fields_.cells[cell])
      for (std::size_t i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], fields_.places[node][i]);
        high[i] = std::max(high[i], fields_.places[node][i]);
      }
    return {point_of(low), point_of(high)};
  }

  [[nodiscard]] static std::vector<double> weights_at(const Place& reference,
                                                      const std::size_t corners) {
    std::vector<double> weights(corners, 1.);
    for (std::size_t corner = 0; corner < corners; ++corner)
      for (std::size_t axis = 0; (std::size_t{1} << axis) < corners; ++axis)
        weights[corner] *= (corner >> axis & 1U) != 0 ? reference[axis] : 1. - reference[axis];
    return weights;
  }

  [[nodiscard]] Place place_at(const std::size_t cell, const std::vector<double>& weights) const {
    Place place{};
    for (std::size_t corner = 0; corner < weights.size(); ++corner)
      for (std::size_t i = 0; i < 3; ++i)
        place[i] += weights[corner] * fields_.places[fields_.cells[cell][corner]][i];
    return place;
  }

  [[nodiscard]] double distance_to(const std::size_t cell, const std::vector<double>& weights,
                                   const Place& place) const {
    const Place there = place_at(cell, weights);
    return std::hypot(there[0] - place[0], there[1] - place[1], there[2] - place[2]);
  }

  /// Weights of the corners at the place's reference coordinates (Newton's method, with the
  /// Jacobian by differences), kept within the cell.
  [[nodiscard]] std::vector<double> clamped_weights(const std::size_t cell,
                                                    const Place& place) const;

  const NodalFields& fields_;
  Tree tree_;
};

/// Solves J x = r of size two or three by Cramer's rule.
Place solved(const std::array<Place, 3>& columns, const Place& r, const std::size_t dim) {
  const auto determinant = [&](const Place& a, const Place& b, const Place& c) {
    if (dim == 2) return a[0] * b[1] - a[1] * b[0];
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) +
           c[0] * (a[1] * b[2] - a[2] * b[1]);
  };
  const auto& [a, b, c] = columns;
  const double whole = determinant(a, b, c);
  if (whole == 0.) return {};
  return {determinant(r, b, c) / whole, determinant(a, r, c) / whole,
          dim == 2 ? 0. : determinant(a, b, r) / whole};
}

std::vector<double> StressAt::clamped_weights(const std::size_t cell, const Place& place) const {
  constexpr int steps = 8;
  constexpr double difference = 1e-6;
  const std::size_t corners = fields_.cells[cell].size();
  const std::size_t dim = corners == 4 ? 2 : 3;
  Place reference{0.5, 0.5, dim == 2 ? 0. : 0.5};
  for (int step = 0; step < steps; ++step) {
    const Place there = place_at(cell, weights_at(reference, corners));
    std::array<Place, 3> columns{};
    for (std::size_t axis = 0; axis < dim; ++axis) {
      Place beside = reference;
      beside[axis] += difference;
      const Place moved = place_at(cell, weights_at(beside, corners));
      for (std::size_t i = 0; i < 3; ++i) columns[axis][i] = (moved[i] - there[i]) / difference;
    }
    const Place change =
        solved(columns, {place[0] - there[0], place[1] - there[1], place[2] - there[2]}, dim);
    for (std::size_t axis = 0; axis < dim; ++axis)
      reference[axis] = std::clamp(reference[axis] + change[axis], -1., 2.);
  }
  for (std::size_t axis = 0; axis < dim; ++axis)
    reference[axis] = std::clamp(reference[axis], 0., 1.);
  return weights_at(reference, corners);
}

/// Where a material point of the pin at one instant is at another.
Place moved(const Place& place, const CycleFields& from, const CycleFields& to) {
  const double angle = -(to.pin_turn - from.pin_turn);
  const double x = place[0] - from.pin_distance;
  return {to.pin_distance + std::cos(angle) * x - std::sin(angle) * place[1],
          std::sin(angle) * x + std::cos(angle) * place[1], place[2]};
}

/// Maximum shear (s1 - s3)/2.
double max_shear(const std::array<double, 6>& stress) {
  std::array<double, 6> opposite = stress;
  for (double& component : opposite) component = -component;
  return 0.5 * (first_principal(stress) + first_principal(opposite));
}

double von_mises_of(const std::array<double, 6>& s) {
  const double normal =
      std::pow(s[0] - s[1], 2) + std::pow(s[1] - s[2], 2) + std::pow(s[2] - s[0], 2);
  return std::sqrt(0.5 * normal + 3. * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

void keep_greater(const double value, const double angle, const std::size_t node,
                  std::vector<double>& values, std::vector<double>& angles) {
  if (value <= values[node]) return;
  values[node] = value;
  angles[node] = angle;
}

/// An array of a VTK file.
struct VtuArray {
  std::string name;
  std::size_t components;
  std::vector<float> values;
};

/// VTK's encoding: a number of bytes, and the bytes.
template <typename Number>
std::string vtk_encoded(const std::vector<Number>& numbers) {
  std::vector<unsigned char> bytes(sizeof(std::uint32_t) + sizeof(Number) * numbers.size());
  const auto size = static_cast<std::uint32_t>(sizeof(Number) * numbers.size());
  std::memcpy(bytes.data(), &size, sizeof(size));
  if (!numbers.empty()) std::memcpy(bytes.data() + sizeof(size), numbers.data(), size);
  return base::encoded_bytes(bytes);
}

template <typename Number>
std::string data_array(const std::string& type, const std::string& name,
                       const std::size_t components, const std::vector<Number>& values) {
  return fmt::format(
      "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">\n{}\n"
      "</DataArray>\n",
      type, name, components, vtk_encoded(values));
}

std::string vtu_text(const NodalFields& fields, const std::vector<VtuArray>& arrays,
                     const double length_factor) {
  std::vector<float> points;
  for (const auto& place : fields.places)
    for (const double coordinate : place)
      points.push_back(static_cast<float>(length_factor * coordinate));
  std::vector<std::int32_t> connectivity;
  std::vector<std::int32_t> offsets;
  std::vector<std::uint8_t> types;
  std::vector<std::int32_t> bodies;
  for (std::size_t cell = 0; cell < fields.cells.size(); ++cell) {
    const std::vector<std::size_t>& nodes = fields.cells[cell];
    for (std::size_t face = 0; face < nodes.size(); face += 4)
      for (const unsigned int corner : {0U, 1U, 3U, 2U})
        connectivity.push_back(static_cast<std::int32_t>(nodes[face + corner]));
    offsets.push_back(static_cast<std::int32_t>(connectivity.size()));
    types.push_back(nodes.size() == 4 ? 9 : 12);
    bodies.push_back(static_cast<std::int32_t>(fields.bodies[cell]));
  }
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" header_type=\"UInt32\">\n<UnstructuredGrid>\n" +
      fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<PointData>\n",
                  fields.places.size(), fields.cells.size());
  for (const VtuArray& array : arrays)
    text += data_array("Float32", array.name, array.components, array.values);
  text += "</PointData>\n<CellData>\n" + data_array("Int32", "body", 1, bodies) +
          "</CellData>\n<Points>\n" + data_array("Float32", "Points", 3, points) +
          "</Points>\n<Cells>\n" + data_array("Int32", "connectivity", 1, connectivity) +
          data_array("Int32", "offsets", 1, offsets) + data_array("UInt8", "types", 1, types) +
          "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return text;
}

template <std::size_t n>
VtuArray array_of(const std::string& name, const std::vector<std::array<double, n>>& values,
                  const double factor) {
  VtuArray array{name, n, {}};
  for (const auto& value : values)
    for (const double component : value)
      array.values.push_back(static_cast<float>(factor * component));
  return array;
}

VtuArray array_of(const std::string& name, const std::vector<double>& values, const double factor) {
  VtuArray array{name, 1, {}};
  for (const double value : values) array.values.push_back(static_cast<float>(factor * value));
  return array;
}

std::string instant_text(const CycleFields& instant, const OutputUnit& length,
                         const OutputUnit& stress) {
  const NodalFields& fields = instant.fields;
  return vtu_text(fields,
                  {array_of("displacement", fields.displacements, length.factor),
                   array_of("stress", fields.stress, stress.factor),
                   array_of("von_mises", fields.von_mises, stress.factor)},
                  length.factor);
}

std::string envelope_text(const NodalFields& fields, const Envelope& greatest,
                          const OutputUnit& length, const OutputUnit& stress,
                          const OutputUnit& angle) {
  return vtu_text(
      fields,
      {array_of("von_mises", greatest.von_mises, stress.factor),
       array_of("von_mises_driver_angle", greatest.von_mises_angle, angle.factor),
       array_of("principal_stress_1", greatest.first_principal, stress.factor),
       array_of("principal_stress_1_driver_angle", greatest.first_principal_angle, angle.factor),
       array_of("max_shear", greatest.max_shear, stress.factor),
       array_of("max_shear_driver_angle", greatest.max_shear_angle, angle.factor)},
      length.factor);
}

}  // namespace

Envelope envelope(const std::vector<CycleFields>& instants, const std::size_t at,
                  const std::vector<bool>& turning) {
  const CycleFields& own = instants[at];
  const std::size_t n_nodes = own.fields.places.size();
  std::vector<unsigned int> body(n_nodes, 0);
  for (std::size_t cell = 0; cell < own.fields.cells.size(); ++cell)
    for (const std::size_t node : own.fields.cells[cell]) body[node] = own.fields.bodies[cell];
  const std::vector<double> least(n_nodes, std::numeric_limits<double>::lowest());
  const std::vector<double> zeros(n_nodes, 0.);
  Envelope greatest{least, zeros, least, zeros, least, zeros};
  for (const CycleFields& instant : instants) {
    const StressAt stress_at(instant.fields);
    for (std::size_t node = 0; node < n_nodes; ++node) {
      const Place& place = own.fields.places[node];
      const auto stress =
          &instant == &own
              ? own.fields.stress[node]
              : stress_at(turning[body[node]] ? moved(place, own, instant) : place, body[node]);
      const double angle = instant.driver_angle;
      keep_greater(von_mises_of(stress), angle, node, greatest.von_mises, greatest.von_mises_angle);
      keep_greater(first_principal(stress), angle, node, greatest.first_principal,
                   greatest.first_principal_angle);
      keep_greater(max_shear(stress), angle, node, greatest.max_shear, greatest.max_shear_angle);
    }
  }
  return greatest;
}

std::map<std::string, std::string> cycle_series(const std::vector<CycleFields>& instants,
                                                const std::size_t at,
                                                const std::vector<bool>& turning,
                                                const base::UnitSystem units) {
  const OutputUnit length = base::output_unit(units, Dimension::length);
  const OutputUnit stress = base::output_unit(units, Dimension::stress);
  const OutputUnit angle = base::output_unit(units, Dimension::angle);
  std::map<std::string, std::string> texts;
  std::string list =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
  for (std::size_t i = 0; i < instants.size(); ++i) {
    const std::string name = fmt::format("cycle.{}.vtu", i);
    texts[name] = instant_text(instants[i], length, stress);
    list += fmt::format("<DataSet timestep=\"{:.9g}\" part=\"0\" file=\"{}\"/>\n",
                        instants[i].driver_angle * angle.factor, name);
  }
  texts["cycle.pvd"] = list + "</Collection>\n</VTKFile>\n";
  texts["envelope.vtu"] =
      envelope_text(instants[at].fields, envelope(instants, at, turning), length, stress, angle);
  return texts;
}

}  // namespace geneva::post
