#include <gtest/gtest.h>

#include <cmath>

#include "post/analysis/closed_form_in_space.h"

namespace {

using namespace geneva;
using dealii::Point;
using dealii::SymmetricTensor;
using dealii::Tensor;

constexpr double poissons_ratio = 0.3;

/// A contact that leans, with its centre of pressure nearer to one end of the loaded length.
struct LeaningLine {
  LeaningLine() {
    const double c = std::cos(0.4);
    const double s = std::sin(0.4);
    frame.centre = {0.1, 0.2, 0.005};
    frame.normal = Tensor<1, 3>({-s, c, 0.});
    frame.across = Tensor<1, 3>({c, s, 0.});
    frame.along = Tensor<1, 3>({0., 0., 1.});
    form.length = 0.02;
    form.middle = -0.004;  // from z = -0.009 to 0.011
    form.line = loads::hertz_line(1e5, 0.01, 1e11);
  }

  [[nodiscard]] Point<3> at(const double across, const double depth, const double along) const {
    return frame.centre + across * frame.across - depth * frame.normal + along * frame.along;
  }
  [[nodiscard]] std::optional<SymmetricTensor<2, 3>> stress(const Point<3>& place) const {
    return post::mcewen_stress(form, frame, poissons_ratio, place);
  }

  post::ContactFrame frame{};
  post::ClosedFormInSpace form{};
};

TEST(McEwenInSpace, IsHisPlaneStressInTheContactsFrame) {
  const LeaningLine contact;
  const double b = contact.form.line->half_width;
  for (const double x : {-1.3, 0., 0.4})
    for (const double z : {0.1, 0.786, 2.5}) {
      const auto stress = contact.stress(contact.at(x * b, z * b, -0.003));
      ASSERT_TRUE(stress);
      const loads::ContactStress plane = contact.form.line->stress(x * b, z * b);
      const double p0 = contact.form.line->peak_pressure;
      const post::ContactFrame& frame = contact.frame;
      EXPECT_NEAR(frame.across * (*stress * frame.across), plane.xx, 1e-12 * p0);
      EXPECT_NEAR(frame.normal * (*stress * frame.normal), plane.zz, 1e-12 * p0);
      EXPECT_NEAR(frame.across * (*stress * -frame.normal), plane.xz, 1e-12 * p0);
      EXPECT_NEAR(frame.along * (*stress * frame.along), poissons_ratio * (plane.xx + plane.zz),
                  1e-12 * p0);
      EXPECT_NEAR(frame.along * (*stress * frame.across), 0., 1e-12 * p0);
    }
}

TEST(McEwenInSpace, IsTheSameInBothBodies) {
  const LeaningLine contact;
  const double b = contact.form.line->half_width;
  const auto below = contact.stress(contact.at(0.7 * b, 0.5 * b, 0.));
  const auto above = contact.stress(contact.at(0.7 * b, -0.5 * b, 0.));
  ASSERT_TRUE(below && above);
  const post::ContactFrame& frame = contact.frame;
  const double p0 = contact.form.line->peak_pressure;
  EXPECT_NEAR(frame.normal * (*below * frame.normal), frame.normal * (*above * frame.normal),
              1e-12 * p0);
  EXPECT_NEAR(frame.across * (*below * frame.normal), -(frame.across * (*above * frame.normal)),
              1e-12 * p0);
}

TEST(McEwenInSpace, EndsWithTheLoadedLengthAndTheZone) {
  const LeaningLine contact;
  const double b = contact.form.line->half_width;
  EXPECT_TRUE(contact.stress(contact.at(0., b, 0.0059)));
  EXPECT_FALSE(contact.stress(contact.at(0., b, 0.0061)));
  EXPECT_TRUE(contact.stress(contact.at(0., b, -0.0139)));
  EXPECT_FALSE(contact.stress(contact.at(0., b, -0.0141)));
  EXPECT_FALSE(contact.stress(contact.at(4.1 * b, b, 0.)));
  EXPECT_FALSE(contact.stress(contact.at(0., 6.1 * b, 0.)));
}

TEST(McEwenInSpace, IsUnknownBelowAnEllipse) {
  LeaningLine contact;
  contact.form.line.reset();
  contact.form.ellipse = loads::hertz_ellipse(1e3, 0.05, 0.01, 1e11);
  EXPECT_FALSE(contact.stress(contact.at(0., 1e-5, 0.)));
}

TEST(EvenLinePressure, IsWhereTheLoadIs) {
  const LeaningLine contact;
  const double p0 = contact.form.line->peak_pressure;
  EXPECT_DOUBLE_EQ(contact.form.pressure(0., 0.0059), p0);
  EXPECT_DOUBLE_EQ(contact.form.pressure(0., -0.0139), p0);
  EXPECT_EQ(contact.form.pressure(0., 0.0061), 0.);
  EXPECT_EQ(contact.form.pressure(0., -0.0141), 0.);
}

}  // namespace
