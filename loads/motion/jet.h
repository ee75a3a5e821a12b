#pragma once

#include <cmath>

namespace geneva::loads {

/// A function's value and first three derivatives at a point (its 3-jet): arithmetic on jets
/// differentiates exactly, by Leibniz's rule and the chain rule of third order (Faa di Bruno).
///
/// A mechanism writes its position once, and speed, acceleration and jerk follow. The derivatives
/// are infinite or nan where the function has none, as sqrt at 0.
struct Jet {
  double value = 0.;
  double first = 0.;
  double second = 0.;
  double third = 0.;
};

/// The variable itself: derivative 1.
inline Jet variable(double value) { return {value, 1., 0., 0.}; }
inline Jet constant(double value) { return {value, 0., 0., 0.}; }

/// Jet of f(g), where outer is that of f at the value of g with respect to its own argument.
inline Jet chain(const Jet& outer, const Jet& g) {
  return {outer.value, outer.first * g.first,
          outer.second * g.first * g.first + outer.first * g.second,
          outer.third * g.first * g.first * g.first + 3. * outer.second * g.first * g.second +
              outer.first * g.third};
}

inline Jet operator+(const Jet& a, const Jet& b) {
  return {a.value + b.value, a.first + b.first, a.second + b.second, a.third + b.third};
}
inline Jet operator-(const Jet& a) { return {-a.value, -a.first, -a.second, -a.third}; }
inline Jet operator-(const Jet& a, const Jet& b) { return a + -b; }
inline Jet operator*(const Jet& a, const Jet& b) {
  return {a.value * b.value, a.first * b.value + a.value * b.first,
          a.second * b.value + 2. * a.first * b.first + a.value * b.second,
          a.third * b.value + 3. * (a.second * b.first + a.first * b.second) + a.value * b.third};
}
inline Jet operator*(double factor, const Jet& a) { return constant(factor) * a; }
inline Jet operator+(const Jet& a, double b) { return {a.value + b, a.first, a.second, a.third}; }
inline Jet operator+(double a, const Jet& b) { return b + a; }
inline Jet operator-(const Jet& a, double b) { return a + -b; }
inline Jet operator-(double a, const Jet& b) { return -b + a; }

inline Jet reciprocal(const Jet& a) {
  const double r = 1. / a.value;
  return chain({r, -r * r, 2. * r * r * r, -6. * r * r * r * r}, a);
}
inline Jet operator/(const Jet& a, const Jet& b) { return a * reciprocal(b); }

inline Jet sqrt(const Jet& a) {
  const double root = std::sqrt(a.value);
  return chain({root, 0.5 / root, -0.25 / (root * a.value), 0.375 / (root * a.value * a.value)}, a);
}
inline Jet sin(const Jet& a) {
  const double s = std::sin(a.value);
  const double c = std::cos(a.value);
  return chain({s, c, -s, -c}, a);
}
inline Jet cos(const Jet& a) {
  const double s = std::sin(a.value);
  const double c = std::cos(a.value);
  return chain({c, -s, -c, s}, a);
}
inline Jet asin(const Jet& a) {
  const double x = a.value;
  const double w = 1. / (1. - x * x);
  const double root = std::sqrt(w);
  return chain({std::asin(x), root, x * w * root, (1. + 2. * x * x) * w * w * root}, a);
}

/// The angle of the point (x, y), with the derivatives of the continuous angle.
inline Jet atan2(const Jet& y, const Jet& x) {
  // d(angle) = (x dy - y dx)/(x^2 + y^2); its own derivatives follow from those of the quotient.
  const Jet numerator{
      x.value * y.first - y.value * x.first, x.value * y.second - y.value * x.second,
      x.first * y.second + x.value * y.third - y.first * x.second - y.value * x.third, 0.};
  const Jet squares = x * x + y * y;
  const Jet rate = numerator / squares;  // its third derivative is not used
  return {std::atan2(y.value, x.value), rate.value, rate.first, rate.second};
}

}  // namespace geneva::loads
