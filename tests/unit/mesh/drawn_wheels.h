#pragma once

#include <map>
#include <string>
#include <vector>

#include "loads/design/johnson.h"
#include "loads/wheel/outline.h"
#include "mesh/mesh_data.h"

namespace geneva::mesh::test {

/// The two types of wheel that are drawn as a whole.
enum class WheelType { external, internal };

/// Wheel and pin, meshed as the program does it.
struct DrawnWheel {
  loads::CommonDimensions dimensions;
  double pin_distance;                   ///< [m]
  double size;                           ///< maximum radius [m]
  std::map<std::string, double> radius;  ///< of the circles by surface [m]
  std::vector<loads::Outline> outlines;  ///< wheel and pin
  MeshData<2> mesh;
};

/// @param way of the pin along the driving wall: 0 nearest to the wheel's axis, 1 farthest
DrawnWheel meshed(const loads::GenevaDimensionsInput& input, double way = 0.1);
DrawnWheel meshed(const loads::InternalDimensionsInput& input, double way = 0.1);
DrawnWheel meshed(WheelType type, int stations, double diameter = 0.1, double way = 0.1);

/// Input with nothing but stations and diameter.
template <typename Input>
Input wheel_of(const int stations, const double diameter = 0.1) {
  Input input{};
  input.stations = stations;
  input.wheel_diameter = diameter;
  return input;
}

/// The wheel of 0.1 m with the pin a tenth of its way out; meshed once, which takes most of the
/// tests' time.
const DrawnWheel& usual(WheelType type, int stations);

}  // namespace geneva::mesh::test
