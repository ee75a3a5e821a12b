#include "loads/pin/pin_line.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/errors.h"
#include "loads/pi.h"
#include "loads/pin/cylinder_kernel.h"
#include "loads/pin/pin_beam.h"
#include "loads/pin/strip_influence.h"
#include "loads/require.h"

namespace geneva::loads {

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// Deflection of a beam by Timoshenko's theory, held at s = 0 alone or there and at its end.
class Beam {
 public:
  explicit Beam(const PinLine& pin)
      : length_(pin.clearance.upper_end - pin.clearance.lower_end),
        is_held_twice_(pin.held_at_both_ends) {
    const double nu = pin.pin.poissons_ratio;
    const double area = pi * pin.radius * pin.radius;
    const double shear_modulus = pin.pin.youngs_modulus / (2. * (1. + nu));
    bending_ = pin.pin.youngs_modulus * area * pin.radius * pin.radius / 4.;
    shear_ = shear_coefficient(nu) * shear_modulus * area;
    const double end = held_once(length_, length_);
    const double turned = length_ * length_ / (2. * bending_);
    const double turn = length_ / bending_;
    end_stiffness_ << end, turned, turned, turn;
    end_stiffness_ = end_stiffness_.inverse().eval();
  }

  /// Deflection at s = a under a unit force at b [m/N].
  [[nodiscard]] double flexibility(const double a, const double b) const {
    const double once = held_once(a, b);
    return is_held_twice_ ? once - at_end(a).dot(end_stiffness_ * at_end(b)) : once;
  }

  /// Moment at s = 0 of a unit force at b [m].
  [[nodiscard]] double moment(const double b) const {
    if (!is_held_twice_) return b;
    const Eigen::Vector2d reaction = end_stiffness_ * at_end(b);  // force and moment at the end
    return b - reaction[0] * length_ - reaction[1];
  }

 private:
  [[nodiscard]] double held_once(const double a, const double b) const {
    const double near = std::min(a, b);
    const double far = std::max(a, b);
    return near * near * (3. * far - near) / (6. * bending_) + near / shear_;
  }
  /// Deflection and turn of the end, were it free, under a unit force at b.
  [[nodiscard]] Eigen::Vector2d at_end(const double b) const {
    return {held_once(length_, b), b * b / (2. * bending_)};
  }

  double length_;
  bool is_held_twice_;
  double bending_;  ///< E I [N m^2]
  double shear_;    ///< kappa G A [N]
  Eigen::Matrix2d end_stiffness_;
};

/// By which the images of the loads at the wheel's faces are multiplied, so that the faces are free
/// of shear stress, too (Guilbault 2011).
double image_factor(const double poissons_ratio) {
  return 1.29 - (0.08 - poissons_ratio / 2.) / (1. - poissons_ratio);
}

/// Places where the wall is cut into sections, ascending.
using Edges = std::vector<double>;

/// The pin's sections and what does not change with the load.
class Sections {
 public:
  Sections(const PinLine& pin, const Edges& edges)
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
        slow_(n_, n_),
        fast_(n_, n_),
        tangent_(n_, n_) {
    for (Eigen::Index i = 0; i < n_; ++i) {
      const auto edge = static_cast<std::size_t>(i);
      places_[i] = (edges[edge] + edges[edge + 1]) / 2.;
      widths_[i] = edges[edge + 1] - edges[edge];
      clearance_[i] = pin.clearance.at(places_[i]);
    }
    find_slow(pin);
    for (const Source source : sources) logarithms_.push_back(logarithms_of(source));
  }

  [[nodiscard]] Eigen::Index size() const { return n_; }
  [[nodiscard]] const Vector& places() const { return places_; }
  [[nodiscard]] const Vector& widths() const { return widths_; }
  [[nodiscard]] const Vector& clearance() const { return clearance_; }
  [[nodiscard]] double pressure(const double line_load) const {
    return std::sqrt(line_load * modulus_ / (pi * relative_radius_));
  }

  /// Displacements under the loads, and their derivatives.
  void find_displacements(const Vector& loads, Vector& displacements) {
    displacements.setZero();
    for (Eigen::Index j = 0; j < n_; ++j) {
      if (loads[j] <= 0.) continue;
      find_column(j, loads[j]);
      displacements += loads[j] * (fast_.col(j) + slow_.col(j));
      tangent_.col(j) += slow_.col(j);
    }
  }
  /// Of the columns of sections with a load.
  [[nodiscard]] const Matrix& tangent() const { return tangent_; }

 private:
  /// Loads at their own places, and their images at the wheel's faces.
  enum class Source { load, upper_image, lower_image };
  static constexpr std::array<Source, 3> sources{Source::load, Source::upper_image,
                                                 Source::lower_image};

  [[nodiscard]] double place_of(const Source source, const Eigen::Index j) const {
    if (source == Source::load) return places_[j];
    return (source == Source::upper_image ? 2. : -2.) * wall_half_ - places_[j];
  }
  [[nodiscard]] double share_of(const Source source) const {
    return source == Source::load ? 1. : image_share_;
  }

  void find_slow(const PinLine& pin) {
    const Beam beam(pin);
    const CylinderKernel kernel(pin.pin.poissons_ratio);
    const double nu = pin.pin.poissons_ratio;
    const double shear_modulus = pin.pin.youngs_modulus / (2. * (1. + nu));
    const double more_shear = (1. / shear_coefficient(nu) - kernel.shear_factor()) /
                              (2. * shear_modulus * pi * pin.radius * pin.radius);
    for (Eigen::Index j = 0; j < n_; ++j)
      for (Eigen::Index i = 0; i < n_; ++i) {
        const double distance = places_[i] - places_[j];
        const double half = widths_[j] / 2.;
        const double local = kernel.integral((distance + half) / pin.radius) -
                             kernel.integral((distance - half) / pin.radius);
        slow_(i, j) = widths_[j] * (beam.flexibility(pin.clearance.upper_end - places_[i],
                                                     pin.clearance.upper_end - places_[j]) +
                                    more_shear * std::abs(distance) +
                                    pin.wheel_twist * places_[i] * places_[j]) +
                      local / pin.pin.youngs_modulus;
      }
  }

  /// A of sections far from their loads, whatever the contact's width.
  [[nodiscard]] Matrix logarithms_of(const Source source) const {
    Matrix result(n_, n_);
    for (Eigen::Index j = 0; j < n_; ++j)
      for (Eigen::Index i = 0; i < n_; ++i) {
        const double distance = std::abs(places_[i] - place_of(source, j));
        const double half = widths_[j] / 2.;
        result(i, j) = distance > half ? std::log((distance + half) / (distance - half)) : 0.;
      }
    return result;
  }

  /// What the load of a section does to all, in half-spaces.
  void find_column(const Eigen::Index j, const double load) {
    const double b = std::sqrt(4. * load * relative_radius_ / (pi * modulus_));
    fast_.col(j).setZero();
    tangent_.col(j).setZero();
    for (std::size_t s = 0; s < sources.size(); ++s) {
      const double place = place_of(sources[s], j);
      const double share = share_of(sources[s]) / (pi * modulus_);
      for (Eigen::Index i = 0; i < n_; ++i) {
        const double distance = std::abs(places_[i] - place);
        if (distance - widths_[j] / 2. > far_from_load * b) {
          fast_(i, j) += share * logarithms_[s](i, j);
          tangent_(i, j) += share * logarithms_[s](i, j);
        } else {
          const StripInfluence influence = of_strip(distance / b, widths_[j] / (2. * b));
          fast_(i, j) += share * influence.value;
          tangent_(i, j) += share * influence.derivative;
        }
      }
    }
  }

  /// A of a strip, and d(q A)/dq; b grows with the root of q.
  /// @param distance, half of its width over b
  [[nodiscard]] static StripInfluence of_strip(const double distance, const double half) {
    const double upper = distance + half;
    const double lower = distance - half;
    const StripInfluence of_upper = strip_influence(upper);
    const StripInfluence of_lower = strip_influence(lower);
    const double value = of_upper.value - of_lower.value;
    return {value, value - (upper * of_upper.derivative - lower * of_lower.derivative) / 2.};
  }

  /// In half-widths; A is then a logarithm to 4e-5.
  static constexpr double far_from_load = 40.;

  double modulus_;          ///< E* [Pa]
  double relative_radius_;  ///< R [m]
  double wall_half_;        ///< half of the wheel's thickness [m]
  double image_share_;      ///< of the loads' images at the wheel's faces
  Eigen::Index n_;
  Vector places_;     ///< [m]
  Vector widths_;     ///< [m]
  Vector clearance_;  ///< [m]
  Matrix slow_;       ///< displacement by line load of beam, cylinder and twist [m^2/N]
  Matrix fast_;       ///< the same of half-spaces
  Matrix tangent_;    ///< d displacement/d line load of all
  std::vector<Matrix> logarithms_;  ///< by source
};

/// Newton's iterations with an active set for
/// c + (K(q) + M) q - delta >= 0, q >= 0, and sum q h = F.
class Search {
 public:
  /// @param start first guess of the loads, whose sum is scaled; some positive
  Search(Sections& sections, const double force, const Vector& start)
      : sections_(sections),
        n_(sections.size()),
        force_(force),
        mean_(force / sections.widths().sum()),
        loads_(start * (force / start.dot(sections.widths()))),
        displacements_(n_),
        system_(n_ + 1, n_ + 1),
        rest_(n_ + 1),
        step_(n_ + 1),
        factors_(n_ + 1) {}

  /// @throws base::InputError if it does not end
  void run() {
    constexpr int most_steps = 200;
    constexpr double enough = 1e-10;
    constexpr double settled = 1e-3;  // sections are added only then, or they come and go for ever
    double change = 1.;
    for (int i = 0; i < most_steps; ++i) {
      sections_.find_displacements(loads_, displacements_);
      if (change < settled && !load_overlapping() && change < enough) return;
      change = advance();
    }
    throw base::InputError("the line contacts along the pin find no balance");
  }

  [[nodiscard]] const Vector& loads() const { return loads_; }
  [[nodiscard]] double approach() const { return approach_; }

 private:
  /// One step of Newton.
  /// @return greatest change of a line load over the greatest load
  double advance() {
    assemble();
    factors_.compute(system_);
    step_.noalias() = factors_.solve(rest_);
    double change = 0.;
    for (Eigen::Index i = 0; i < n_; ++i) {
      const double before = loads_[i];
      if (before <= 0.) continue;
      loads_[i] = std::max(before + step_[i], 0.);
      change = std::max(change, std::abs(loads_[i] - before));
    }
    approach_ += step_[n_];
    return change / loads_.maxCoeff();
  }

  void assemble() {
    system_.setZero();
    rest_.setZero();
    for (Eigen::Index i = 0; i < n_; ++i) {
      if (loads_[i] <= 0.) {
        system_(i, i) = 1.;
        continue;
      }
      for (Eigen::Index j = 0; j < n_; ++j)
        if (loads_[j] > 0.) system_(i, j) = sections_.tangent()(i, j);
      system_(i, n_) = -1.;
      system_(n_, i) = sections_.widths()[i];
      rest_[i] = approach_ - sections_.clearance()[i] - displacements_[i];
    }
    rest_[n_] = force_ - loads_.dot(sections_.widths());
  }

  /// Gives the sections that overlap a load.
  /// @return whether there are any
  bool load_overlapping() {
    bool has_changed = false;
    for (Eigen::Index i = 0; i < n_; ++i)
      if (loads_[i] <= 0. && sections_.clearance()[i] + displacements_[i] < approach_) {
        loads_[i] = first_load * mean_;
        has_changed = true;
      }
    if (has_changed) sections_.find_displacements(loads_, displacements_);
    return has_changed;
  }

  static constexpr double first_load = 1e-6;  // of a section that is loaded anew, over the mean

  Sections& sections_;
  Eigen::Index n_;
  double force_;
  double mean_;
  Vector loads_;
  Vector displacements_;
  double approach_ = 0.;
  Matrix system_;
  Vector rest_;
  Vector step_;
  Eigen::PartialPivLU<Matrix> factors_;
};

/// The vertex of a parabola through three places around the greatest load.
void find_peak(const Sections& sections, PinLineContact& contact) {
  const auto& all = contact.sections;
  const auto top = std::max_element(
      all.begin(), all.end(),
      [](const PinSection& a, const PinSection& b) { return a.line_load < b.line_load; });
  double load = top->line_load;
  contact.peak_place = top->place;
  if (top != all.begin() && top + 1 != all.end()) {
    const double before = top->place - (top - 1)->place;
    const double after = (top + 1)->place - top->place;
    const double rise_before = (load - (top - 1)->line_load) / before;
    const double rise_after = ((top + 1)->line_load - load) / after;
    const double curve = (rise_after - rise_before) / (before + after);
    const double slope = (rise_before * after + rise_after * before) / (before + after);
    if (curve < 0.) {
      load -= slope * slope / (4. * curve);
      contact.peak_place -= slope / (2. * curve);
    }
  }
  contact.peak_line_load = load;
  contact.peak_pressure = sections.pressure(load);
}

/// Where the load begins, seen from the first of the sections: on a smooth pin it rises from 0 in a
/// straight line, as Hertz's does.
template <typename Iterator>
double end_of_contact(const Iterator first, const Iterator last) {
  const auto loaded =
      std::find_if(first, last, [](const PinSection& section) { return section.line_load > 0.; });
  const double outwards = first->place < (last - 1)->place ? -1. : 1.;
  const double reach = loaded->width / 2.;
  if (loaded == first || loaded + 1 == last || (loaded + 1)->line_load <= loaded->line_load)
    return loaded->place + outwards * reach;
  const double rise =
      ((loaded + 1)->line_load - loaded->line_load) / std::abs((loaded + 1)->place - loaded->place);
  return loaded->place + outwards * std::clamp(loaded->line_load / rise, 0., 2. * reach);
}

PinLineContact contact_of(const PinLine& pin, const Sections& sections, const Search& search) {
  PinLineContact contact;
  const Beam beam(pin);
  for (Eigen::Index i = 0; i < sections.size(); ++i) {
    const double place = sections.places()[i];
    const double width = sections.widths()[i];
    const double load = search.loads()[i];
    contact.sections.push_back({place, width, load});
    contact.root_moment += load * width * beam.moment(pin.clearance.upper_end - place);
  }
  contact.begin = end_of_contact(contact.sections.begin(), contact.sections.end());
  contact.end = end_of_contact(contact.sections.rbegin(), contact.sections.rend());
  contact.approach = search.approach();
  contact.root_stress = 4. * contact.root_moment / (pi * std::pow(pin.radius, 3));
  find_peak(sections, contact);
  return contact;
}

/// Loads of other sections at places, by straight lines; beyond them that of the last one.
Vector loads_at(const PinLineContact& known, const Vector& places) {
  Vector result(places.size());
  const auto& all = known.sections;
  for (Eigen::Index i = 0; i < places.size(); ++i) {
    const auto after = std::lower_bound(
        all.begin(), all.end(), places[i],
        [](const PinSection& section, const double place) { return section.place < place; });
    if (after == all.begin() || after == all.end()) {
      result[i] = after == all.end() ? all.back().line_load : after->line_load;
      continue;
    }
    const auto before = after - 1;
    const double share = (places[i] - before->place) / (after->place - before->place);
    result[i] = (1. - share) * before->line_load + share * after->line_load;
  }
  return result;
}

PinLineContact solved(const PinLine& pin, const double force, const Edges& edges,
                      const PinLineContact* const known) {
  Sections sections(pin, edges);
  const Vector start =
      known ? loads_at(*known, sections.places()) : Vector::Ones(sections.size()).eval();
  Search search(sections, force, start);
  search.run();
  return contact_of(pin, sections, search);
}

/// Even sections, or thinner ones towards an end of the wall that the contact reaches.
Edges edges_between(const double begin, const double end, const double wall_half, const int n) {
  const double rounding = 1e-9 * wall_half;
  const bool is_lower = begin < -wall_half + rounding;
  const bool is_upper = end > wall_half - rounding;
  const auto place = [&](const double x) {  // x from 0 to 1
    if (is_lower && is_upper) return 0.5 - 0.5 * std::cos(pi * x);
    if (is_lower) return 1. - std::cos(pi / 2. * x);
    return is_upper ? std::sin(pi / 2. * x) : x;
  };
  Edges edges;
  for (int i = 0; i <= n; ++i)
    edges.push_back(begin + (end - begin) * place(static_cast<double>(i) / n));
  return edges;
}

/// Where sections are to be: the contact of others and a section beyond, within the wall.
std::pair<double, double> window(const PinLineContact& contact, const double wall_half) {
  return {std::max(contact.begin - contact.sections.front().width, -wall_half),
          std::min(contact.end + contact.sections.back().width, wall_half)};
}

void require(const PinLine& pin, const double force) {
  require_positive_length("pin radius", pin.radius);
  require_positive_length("relative radius", pin.relative_radius);
  require_positive_length("wheel thickness", 2. * pin.clearance.wall_half);
  require_positive("pin force", force, "N");
}

}  // namespace

bool ends_inside(const PinLineContact& contact, const PinClearance& clearance) {
  const double flank = clearance.wall_half - clearance.wall_edge.size;
  return contact.begin > -flank && contact.end < flank;
}

PinLineContact pin_line_contact(const PinLine& pin, const double force, const double accuracy) {
  constexpr int on_whole_wall = 16;
  constexpr int fewest = 12;
  constexpr int most = 192;
  constexpr int most_at_edges = 48;  // where the peak grows with them for ever
  require(pin, force);
  const double wall_half = pin.clearance.wall_half;
  PinLineContact coarse = solved(
      pin, force, edges_between(-wall_half, wall_half, 2. * wall_half, on_whole_wall), nullptr);
  for (int n = fewest; n <= most; n *= 2) {
    const auto [begin, end] = window(coarse, wall_half);
    PinLineContact contact = solved(pin, force, edges_between(begin, end, wall_half, n), &coarse);
    contact.error = std::abs(contact.peak_pressure / coarse.peak_pressure - 1.);
    coarse = std::move(contact);
    const bool reaches_edge = coarse.begin <= -wall_half || coarse.end >= wall_half;
    if (n > fewest && (coarse.error <= accuracy || (reaches_edge && n >= most_at_edges))) break;
  }
  return coarse;
}

}  // namespace geneva::loads
