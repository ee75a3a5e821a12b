#include <gtest/gtest.h>

#include <cmath>

#include "loads/wheel/outline.h"
#include "mesh_measures.h"
#include "test_mesher.h"
#include "tests/support/refusal.h"

namespace geneva::mesh {
namespace {

using loads::Outline;
using loads::Point;
using loads::Segment;
using loads::test::expect_refused;
using test::area;

Segment line(Point start, Point end) { return {start, end, false, {0., 0.}, false, "side"}; }

Outline square(double side) {
  return {"square",
          {{line({0., 0.}, {side, 0.}), line({side, 0.}, {side, side}),
            line({side, side}, {0., side}), line({0., side}, {0., 0.})}}};
}

TEST(OutlineMesh, OfASquareIsMadeOfSquares) {
  const MeshData<2> mesh = mesh_outlines({square(1.)}, {0.25, 0.25, {0., 0.}, 1.});
  EXPECT_EQ(mesh.faces.size(), 16U);
  EXPECT_NEAR(area(mesh, 0), 1., 1e-12);
  EXPECT_TRUE(mesh.circles.empty());
}

TEST(OutlineMesh, RefusesSizesThatAreNotPositive) {
  for (const MeshSizing& sizing :
       {MeshSizing{0.1, 0., {0., 0.}, 1.}, MeshSizing{-0.1, 0.1, {0., 0.}, 1.},
        MeshSizing{0.1, 0.2, {0., 0.}, 1.}, MeshSizing{0.1, 0.1, {0., 0.}, 0.},
        MeshSizing{std::nan(""), 0.1, {0., 0.}, 1.}})
    expect_refused([&] { (void)mesh_outlines({square(1.)}, sizing); }, {"cell sizes"});
}

TEST(OutlineMesh, RefusesAnOpenOutline) {
  Outline open = square(1.);
  open.loops[0][2].end = {0.1, 1.};
  expect_refused(
      [&] {
        (void)mesh_outlines({open}, {0.25, 0.25, {0., 0.}, 1.});
      },
      {"square", "open", "(0.1, 1)"});
}

}  // namespace
}  // namespace geneva::mesh
