#include "post/output/cycle_series.h"

#include <gtest/gtest.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/vector.hpp>
#include <cmath>
#include <sstream>
#include <utility>

namespace geneva::post {
namespace {

/// Two squares: a wheel from x = 0 to 1 and a pin around (2, 0), both of side 1; stress xx is a
/// linear function of the place in the pin's own frame or the wheel's.
CycleFields instant(const double angle, const double pin_distance, const double pin_turn,
                    const double factor) {
  CycleFields result{angle, pin_distance, pin_turn, {}};
  const double cosine = std::cos(-pin_turn);
  const double sine = std::sin(-pin_turn);
  for (const unsigned int body : {0U, 1U}) {
    std::vector<std::size_t> cell;
    for (int corner = 0; corner < 4; ++corner) {
      const double x = corner % 2 - 0.5;
      const double y = (corner < 2 ? 0. : 1.) - 0.5;
      cell.push_back(result.fields.places.size());
      const double value = factor * (2.5 + x + 3. * y);
      result.fields.places.push_back(
          body == 0 ? std::array<double, 3>{0.5 + x, y, 0.}
                    : std::array<double, 3>{pin_distance + cosine * x - sine * y,
                                            sine * x + cosine * y, 0.});
      result.fields.displacements.push_back({x, y, 0.});
      result.fields.stress.push_back({value, 0., 0., 0.1, 0., 0.});
      result.fields.von_mises.push_back(std::abs(value));
    }
    result.fields.cells.push_back(cell);
    result.fields.bodies.push_back(body);
  }
  return result;
}

TEST(NodalFields, MirroredTwiceAreTheSame) {
  const NodalFields fields = instant(0., 2., 0.3, 1.).fields;
  const NodalFields once = mirrored(fields);
  EXPECT_EQ(once.places[5][1], -fields.places[5][1]);
  EXPECT_EQ(once.displacements[5][1], -fields.displacements[5][1]);
  EXPECT_EQ(once.stress[5][3], -0.1);
  EXPECT_EQ(once.stress[5][0], fields.stress[5][0]);
  EXPECT_NE(once.cells, fields.cells) << "corners go round the same way";
  const NodalFields twice = mirrored(once);
  EXPECT_EQ(twice.places, fields.places);
  EXPECT_EQ(twice.stress, fields.stress);
  EXPECT_EQ(twice.cells, fields.cells);
}

TEST(FirstPrincipal, IsTheGreatestEigenvalue) {
  EXPECT_NEAR(first_principal({3., 1., -5., 0., 0., 0.}), 3., 1e-14);
  EXPECT_NEAR(first_principal({0., 0., 0., 2., 0., 0.}), 2., 1e-14);
  EXPECT_NEAR(first_principal({-1., -1., -1., 0., 0., 0.}), -1., 1e-14);
  EXPECT_NEAR(first_principal({2., 2., 0., 1., 0., 0.}), 3., 1e-14);
}

TEST(Envelope, FollowsTheWheelAndTheTurningPin) {
  const std::vector<CycleFields> instants{instant(-0.5, 2., 0., 1.), instant(0.1, 1.7, 0.4, 1.5),
                                          instant(0.6, 1.2, 1.1, 0.5)};
  const Envelope greatest = envelope(instants[0], instants, {false, true});
  const NodalFields& own = instants[0].fields;
  for (std::size_t node = 0; node < own.places.size(); ++node) {
    const double here = own.stress[node][0];
    const double principal = [](const double normal) {
      return normal / 2. + std::hypot(normal / 2., 0.1);
    }(here > 0. ? 1.5 * here : 0.5 * here);
    EXPECT_NEAR(greatest.first_principal[node], principal, 1e-9) << node;
    EXPECT_NEAR(greatest.von_mises[node], std::sqrt(std::pow(1.5 * here, 2) + 0.03), 1e-9) << node;
    EXPECT_EQ(greatest.von_mises_when[node], 0.1) << node;
  }
}

TEST(Envelope, AtSomeNodesIsThatOfAllOfThem) {
  const std::vector<CycleFields> instants{instant(-0.5, 2., 0., 1.), instant(0.1, 1.7, 0.4, 1.5),
                                          instant(0.6, 1.2, 1.1, 0.5)};
  const std::vector<bool> turning{false, true};
  const Envelope whole = envelope(instants[1], instants, turning);
  const std::vector<std::size_t> nodes{6, 1, 2};
  EnvelopeOfNodes some(instants[1], turning, nodes);
  for (const CycleFields& at : instants) some.add(at);
  const Envelope found = std::move(some).result();
  ASSERT_EQ(found.von_mises.size(), nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    EXPECT_EQ(found.von_mises[i], whole.von_mises[nodes[i]]);
    EXPECT_EQ(found.first_principal_when[i], whole.first_principal_when[nodes[i]]);
    EXPECT_EQ(found.max_shear[i], whole.max_shear[nodes[i]]);
    EXPECT_EQ(found.tension_least[i], whole.tension_least[nodes[i]]);
  }
}

TEST(NodalFields, TravelAsTheyAre) {
  const NodalFields sent = instant(0.1, 2., 0.3, 1.5).fields;
  std::stringstream stream;
  boost::archive::binary_oarchive(stream) << sent;
  NodalFields found;
  boost::archive::binary_iarchive(stream) >> found;
  EXPECT_EQ(found.places, sent.places);
  EXPECT_EQ(found.displacements, sent.displacements);
  EXPECT_EQ(found.stress, sent.stress);
  EXPECT_EQ(found.von_mises, sent.von_mises);
  EXPECT_EQ(found.cells, sent.cells);
  EXPECT_EQ(found.bodies, sent.bodies);
}

/// As instant(), with a tension along the body's own x axis: a pin's turns with it.
CycleFields pulled(const double angle, const double pin_turn, const double tension) {
  CycleFields result = instant(angle, 2., pin_turn, 1.);
  for (std::size_t node = 0; node < result.fields.stress.size(); ++node) {
    const double turn = node < 4 ? 0. : -pin_turn;
    const double c = std::cos(turn);
    const double s = std::sin(turn);
    result.fields.stress[node] = {tension * c * c, tension * s * s, 0., tension * c * s, 0., 0.};
  }
  return result;
}

TEST(Swing, FollowsTheDirectionOfTheTensionAsItsMaterialTurns) {
  const std::vector<CycleFields> instants{pulled(-0.5, 0., -30.), pulled(0.1, 0.4, 100.),
                                          pulled(0.6, 1.1, 50.)};
  const std::vector<bool> turning{false, true};
  for (const unsigned int body : {0U, 1U}) {
    const CycleStress tensile{
        "body", "tensile stress", 100., 0., "", {body == 0 ? 0.5 : 2.1, 0.1, 0.}, body};
    const Swing swing = swing_of(tensile, instants, 1, turning);
    EXPECT_NEAR(swing.least, -30., 1e-9) << body;
    EXPECT_EQ(swing.driver_angle, -0.5);
  }
  const Envelope greatest = envelope(instants[0], instants, turning);
  for (const double least : greatest.tension_least) EXPECT_NEAR(least, -30., 1e-9);
}

TEST(Swing, IsNothingBetweenEngagements) {
  const std::vector<CycleFields> instants{pulled(-0.5, 0., 20.), pulled(0.1, 0.4, 100.)};
  const CycleStress tensile{"wheel", "tensile stress", 100., 0., "", {0.5, 0., 0.}, 0};
  const Swing swing = swing_of(tensile, instants, 1, {false, true});
  EXPECT_EQ(swing.least, 0.);
  EXPECT_FALSE(swing.driver_angle.has_value());
}

TEST(CycleSeries, NamesEveryInstantAtItsAngle) {
  const std::vector<CycleFields> instants{instant(-0.5, 2., 0., 1.), instant(0.1, 1.7, 0.4, 1.5)};
  const auto units = base::UnitSystem::mm_newton;
  const auto texts =
      cycle_series(instants, instants[1].fields, envelope(instants[1], instants, {false, true}),
                   {"driver_angle", base::output_unit(units, base::Dimension::angle).factor,
                    "cycle", "envelope.vtu"},
                   {}, units);
  EXPECT_EQ(texts.size(), 4U);
  const std::string& list = texts.at("cycle.pvd");
  EXPECT_NE(list.find("timestep=\"-28.6478898\" part=\"0\" file=\"cycle.0.vtu\""),
            std::string::npos)
      << list;
  EXPECT_NE(texts.at("envelope.vtu").find("von_mises_driver_angle"), std::string::npos);
}

}  // namespace
}  // namespace geneva::post
