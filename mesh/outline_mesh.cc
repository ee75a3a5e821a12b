#include "mesh/outline_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"

namespace geneva::mesh {

namespace {

using loads::Loop;
using loads::Outline;
using loads::Point;
using loads::Segment;

/// An end of a segment and the next one's start may differ by rounding.
constexpr double closed = 1e-9;

void check_sizing(const MeshSizing& sizing) {
  const bool fit = sizing.at_contact > 0. && sizing.general >= sizing.at_contact &&
                   sizing.contact_distance > 0. && std::isfinite(sizing.general);
  if (!fit)
    throw base::InputError(fmt::format(
        "cell sizes are {:.6g} mm at the contact and {:.6g} mm in general, over {:.6g} mm: they "
        "must be positive, and that at the contact the smaller one",
        1e3 * sizing.at_contact, 1e3 * sizing.general, 1e3 * sizing.contact_distance));
}

void check_loops(const std::vector<Outline>& outlines, double scale) {
  for (const Outline& outline : outlines) {
    if (outline.loops.empty())
      throw base::InputError(fmt::format("outline '{}' has no boundary", outline.name));
    for (const Loop& loop : outline.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Point gap_end = loop[(i + 1) % loop.size()].start;
        if (std::hypot(loop[i].end.x - gap_end.x, loop[i].end.y - gap_end.y) <= closed * scale)
          continue;
        throw base::InputError(fmt::format(
            "outline '{}' is open: a segment ends at ({:.6g}, {:.6g}) m and the next one starts at "
            "({:.6g}, {:.6g}) m",
            outline.name, loop[i].end.x, loop[i].end.y, gap_end.x, gap_end.y));
      }
  }
}

/// Cells of an eighth of the pin's diameter at the contact.
MeshSizing graded(double general, double pin_diameter, Point contact) {
  const double at_contact = std::min(pin_diameter / 8., general);
  const double zone_growth = 0.15;  // per length: a faster one distorts the cells near the contact
  return {general, at_contact, contact,
          std::max((general - at_contact) / zone_growth, pin_diameter)};
}

}  // namespace

MeshSizing default_sizing(const loads::GenevaDimensions& dimensions, double pin_distance) {
  return graded(0.06 * dimensions.wheel_diameter, dimensions.pin_diameter,
                {pin_distance, dimensions.slot_width / 2.});
}

MeshSizing default_sizing(const loads::InternalDimensions& dimensions, double pin_distance) {
  return graded(0.12 * dimensions.rim_radius, dimensions.pin_diameter,
                {pin_distance, dimensions.slot_width / 2.});
}

MeshSizing default_sizing(const loads::LocalDimensions& dimensions) {
  return graded(std::max(dimensions.width, dimensions.depth) / 8., dimensions.pin_diameter,
                {0., 0.});
}

MeshData<2> mesh_outlines(const std::vector<Outline>& outlines, const MeshSizing& sizing,
                          Mesher& mesher, const MesherLimits& limits) {
  check_sizing(sizing);
  check_loops(outlines, loads::extent(outlines));
  const MesherAnswer answer = mesher.answer(OutlineTask{outlines, sizing}, limits);
  if (!answer.errors.empty()) throw base::InputError(answer.errors.front());
  auto mesh = mesh_of<2>(answer.mesh);
  check(mesh);
  return mesh;
}

}  // namespace geneva::mesh
