#include "tests/support/line_contact.h"

#include <cmath>

#include "tests/support/structured_mesh.h"

namespace geneva::test {

namespace {

/// Lines of the given spacing and offset between -extent and extent, with a line at either end.
std::vector<double> lines_across(const double extent, const double spacing, const double offset) {
  std::vector<double> lines{-extent};
  const int reach = static_cast<int>(extent / spacing) + 1;
  for (int i = -reach; i <= reach; ++i) {
    const double at = i * spacing + offset;
    if (std::abs(at) < extent - 0.4 * spacing) lines.push_back(at);
  }
  lines.push_back(extent);
  return lines;
}

loads::Elastic elastic(const fem::Material& material) {
  return {material.youngs_modulus, material.poissons_ratio};
}

}  // namespace

mesh::MeshData<2> mesh_of(const LineContact& contact) {
  const double R = contact.radius;
  mesh::MeshData<2> mesh = empty_mesh();
  Ring ring;
  ring.centre = {0., R};
  const auto layers = static_cast<unsigned int>(std::lround(4. * (1. - contact.core)));
  ring.radii = equal_steps(contact.core * R, R, layers);
  const double step = 2. * std::acos(-1.) / contact.cells_around;
  const double start = -0.5 * std::acos(-1.) + contact.turn * step;
  ring.angles = equal_steps(start, start + 2. * std::acos(-1.), contact.cells_around);
  ring.inner = "core";
  ring.outer = "cylinder";
  add_ring(mesh, "cylinder", ring);
  const double spacing = contact.block_cell * R;
  add_rectangle(mesh, "block", lines_across(4. * R, spacing, contact.shift * spacing),
                equal_steps(-4. * R, 0., static_cast<unsigned int>(std::lround(4. * R / spacing))),
                {"bottom", "", "top", ""});
  return mesh;
}

fem::Problem<2> problem_of(const LineContact& contact) {
  fem::Problem<2> problem;
  problem.plane = contact.plane;
  problem.thickness = contact.thickness;
  problem.bodies = {{"cylinder", contact.cylinder, {}}, {"block", contact.block, {}}};
  problem.supports = {{"bottom", {0., 0.}}};
  problem.ties = {{"core", {0., -1.}, contact.force}};
  problem.pairs = {{"cylinder", "top"}};
  if (contact.block_is_source) problem.pairs = {{"top", "cylinder"}};
  return problem;
}

loads::HertzLine hertz(const LineContact& contact) {
  const loads::Elastic first = elastic(contact.cylinder);
  const loads::Elastic second = elastic(contact.block);
  const double modulus = contact.plane == fem::PlaneKind::plane_stress
                             ? loads::contact_modulus_plane_stress(first, second)
                             : loads::contact_modulus(first, second);
  return loads::hertz_line(contact.force / contact.thickness, contact.radius, modulus);
}

}  // namespace geneva::test
