#include "post/output/vtu_text.h"

#include <fmt/format.h>

#include <cstdint>

#include "base/base64.h"

namespace geneva::post {

namespace {

template <typename Value>
void append(std::vector<unsigned char>& bytes, const Value* const values, const std::size_t count) {
  const auto* const first = reinterpret_cast<const unsigned char*>(values);
  bytes.insert(bytes.end(), first, first + sizeof(Value) * count);
}

/// VTK's encoding: a number of bytes, and the bytes.
template <typename Number>
std::string vtk_encoded(const std::vector<Number>& numbers) {
  const auto size = static_cast<std::uint32_t>(sizeof(Number) * numbers.size());
  std::vector<unsigned char> bytes;
  append(bytes, &size, 1);
  append(bytes, numbers.data(), numbers.size());
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

}  // namespace

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

}  // namespace geneva::post
