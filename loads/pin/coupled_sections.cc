#include "loads/pin/coupled_sections.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "loads/hertz.h"
#include "loads/pi.h"
#include "loads/pin/cylinder_kernel.h"
#include "loads/pin/held_beam.h"
#include "loads/pin/pin_beam.h"
#include "loads/pin/slab_kernel.h"

namespace geneva::loads {

namespace {

/// In half-widths; A is then the integral of (1 - b^2/(8 s^2))/s over the section, to (b/s)^4/21.
constexpr double far_from_load = 16.;
constexpr double beyond_any_width = 1e3;

PinInside inside_of(const PinLine& pin) {
  if (pin.hold == PinHold::core) return PinInside::held_core;
  return pin.inner_radius > 0. ? PinInside::hollow : PinInside::solid;
}

/// Half of what a force shears a pin's generator more than its beam, by distance [1/N]; nothing of
/// a pin that is no beam.
double more_shear(const PinLine& pin, const CylinderKernel& kernel) {
  if (pin.hold == PinHold::core) return 0.;
  const double nu = pin.pin.poissons_ratio;
  const double shear_modulus = pin.pin.youngs_modulus / (2. * (1. + nu));
  const double area = pi * (pin.radius * pin.radius - pin.inner_radius * pin.inner_radius);
  return (1. / shear_coefficient(nu, pin.inner_radius / pin.radius) - kernel.shear_factor()) /
         (2. * shear_modulus * area);
}

}  // namespace

CoupledSections::CoupledSections(const PinLine& pin, const SectionEdges& edges)
    : modulus_(contact_modulus(pin.pin, pin.wheel)),
      relative_radius_(pin.relative_radius),
      wall_half_(pin.clearance.wall_half),
      image_share_(image_factor(pin.wheel.poissons_ratio) * modulus_ *
                   (1. - pin.wheel.poissons_ratio * pin.wheel.poissons_ratio) /
                   pin.wheel.youngs_modulus),
      n_(static_cast<Eigen::Index>(edges.size()) - 1),
      places_(n_),
      widths_(n_),
      clearance_(n_),
      slow_(Eigen::MatrixXd::Zero(n_, n_)),
      fast_(n_, n_),
      tangent_(n_, n_) {
  for (Eigen::Index i = 0; i < n_; ++i) {
    const auto edge = static_cast<std::size_t>(i);
    places_[i] = (edges[edge] + edges[edge + 1]) / 2.;
    widths_[i] = edges[edge + 1] - edges[edge];
    clearance_[i] = pin.clearance.at(places_[i]);
  }
  append_pin(pin, edges);
  append_wheel(pin);
  for (const Source source : sources) far_.push_back(far_influence_of(source));
}

double CoupledSections::square_per_load() const { return 4. * relative_radius_ / (pi * modulus_); }

double CoupledSections::half_width(const Eigen::Index section, const double line_load) const {
  return bending_ ? bending_->half_widths()[section] : std::sqrt(square_per_load() * line_load);
}

void CoupledSections::choose_far(const double line_load) {
  far_distance_ = far_from_load * std::sqrt(square_per_load() * line_load);
}

void CoupledSections::widen_by_bending() { bending_.emplace(places_, widths_, square_per_load()); }

void CoupledSections::find_displacements(const Eigen::VectorXd& loads,
                                         Eigen::VectorXd& displacements) {
  if (bending_) bending_->follow(loads);
  displacements.setZero();
  for (Eigen::Index j = 0; j < n_; ++j) {
    if (loads[j] <= 0.) continue;
    find_column(j, loads[j]);
    displacements += loads[j] * (fast_.col(j) + slow_.col(j));
    tangent_.col(j) += slow_.col(j);
  }
}

double CoupledSections::place_of(const Source source, const Eigen::Index j) const {
  if (source == Source::load) return places_[j];
  return (source == Source::upper_image ? 2. : -2.) * wall_half_ - places_[j];
}

double CoupledSections::share_of(const Source source) const {
  return source == Source::load ? 1. : image_share_;
}

/// Beam, and what a round cylinder gives way more than it and a half-space.
void CoupledSections::append_pin(const PinLine& pin, const SectionEdges& edges) {
  const HeldBeam beam(pin);
  const CylinderKernel kernel(pin.pin.poissons_ratio, inside_of(pin),
                              pin.inner_radius / pin.radius);
  const double shear = more_shear(pin, kernel);
  const double root = pin.clearance.upper_end;
  for (Eigen::Index i = 0; i < n_; ++i) {
    // a section ends where the next begins: one integral for both
    double to_lower_edge = kernel.integral((places_[i] - edges.front()) / pin.radius);
    for (Eigen::Index j = 0; j < n_; ++j) {
      const double upper_edge = edges[static_cast<std::size_t>(j) + 1];
      const double to_upper_edge = kernel.integral((places_[i] - upper_edge) / pin.radius);
      slow_(i, j) += widths_[j] * (beam.flexibility(root - places_[i], root - places_[j]) +
                                   shear * std::abs(places_[i] - places_[j])) +
                     (to_lower_edge - to_upper_edge) / pin.pin.youngs_modulus;
      to_lower_edge = to_upper_edge;
    }
  }
}

/// Plate, and the turn of the wheel.
void CoupledSections::append_wheel(const PinLine& pin) {
  const SlabKernel slab(pin.wheel.poissons_ratio);
  const double scale = 1. / (pin.wheel.youngs_modulus * 2. * wall_half_);
  std::vector<SlabKernel::Polynomials> polynomials;
  for (Eigen::Index i = 0; i < n_; ++i)
    polynomials.push_back(SlabKernel::polynomials(places_[i] / wall_half_));
  for (Eigen::Index j = 0; j < n_; ++j)
    for (Eigen::Index i = 0; i < n_; ++i)
      slow_(i, j) += widths_[j] * (scale * slab.value(polynomials[static_cast<std::size_t>(i)],
                                                      polynomials[static_cast<std::size_t>(j)]) +
                                   pin.wheel_twist * places_[i] * places_[j]);
}

CoupledSections::Far CoupledSections::far_influence_of(const Source source) const {
  Far far{Eigen::MatrixXd::Zero(n_, n_), Eigen::MatrixXd::Zero(n_, n_)};
  for (Eigen::Index j = 0; j < n_; ++j)
    for (Eigen::Index i = 0; i < n_; ++i) {
      const double distance = std::abs(places_[i] - place_of(source, j));
      const double upper = distance + widths_[j] / 2.;
      const double lower = distance - widths_[j] / 2.;
      if (lower <= 0.) continue;
      far.logarithm(i, j) = std::log(upper / lower);
      far.by_width(i, j) = (1. / (upper * upper) - 1. / (lower * lower)) / 16.;
    }
  return far;
}

/// What the load of a section does to all, in half-spaces.
void CoupledSections::find_column(const Eigen::Index j, const double load) {
  const double b = half_width(j, load);
  const double of_own_width = bending_ ? 0. : 1.;  // b^2 goes with q
  const double far = std::min(far_distance_, beyond_any_width * b);
  fast_.col(j).setZero();
  tangent_.col(j).setZero();
  for (std::size_t s = 0; s < sources.size(); ++s) {
    const double place = place_of(sources[s], j);
    const double share = share_of(sources[s]) / (pi * modulus_);
    for (Eigen::Index i = 0; i < n_; ++i) {
      const double distance = std::abs(places_[i] - place);
      if (distance - widths_[j] / 2. > far) {
        const double of_width = b * b * far_[s].by_width(i, j);
        fast_(i, j) += share * (far_[s].logarithm(i, j) + of_width);
        tangent_(i, j) += share * (far_[s].logarithm(i, j) + (1. + of_own_width) * of_width);
      } else {
        const StripInfluence influence = of_strip(distance / b, widths_[j] / (2. * b));
        fast_(i, j) += share * influence.value;
        tangent_(i, j) += share * (bending_ ? influence.value : influence.derivative);
      }
    }
  }
}

/// A of a strip, and d(q A)/dq; b grows with the root of q.
/// @param distance, half of its width over b
StripInfluence CoupledSections::of_strip(const double distance, const double half) {
  const double upper = distance + half;
  const double lower = distance - half;
  const StripInfluence of_upper = strip_influence(upper);
  const StripInfluence of_lower = strip_influence(lower);
  const double value = of_upper.value - of_lower.value;
  return {value, value - (upper * of_upper.derivative - lower * of_lower.derivative) / 2.};
}

}  // namespace geneva::loads
