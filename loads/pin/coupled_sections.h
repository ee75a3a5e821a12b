#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "loads/pin/bending_width.h"
#include "loads/pin/pin_line.h"
#include "loads/pin/strip_influence.h"

namespace geneva::loads {

/// Places where the wall is cut into sections, ascending [m].
using SectionEdges = std::vector<double>;

/// The sections of a pin, what their loads do to all of them, and what does not change with the
/// loads.
class CoupledSections {
 public:
  /// @throws base::InputError where a kernel does
  CoupledSections(const PinLine& pin, const SectionEdges& edges);

  [[nodiscard]] Eigen::Index size() const { return n_; }
  [[nodiscard]] const Eigen::VectorXd& places() const { return places_; }
  [[nodiscard]] const Eigen::VectorXd& widths() const { return widths_; }
  [[nodiscard]] const Eigen::VectorXd& clearance() const { return clearance_; }

  /// Which sections are far from each other, from now on: a choice that followed the loads would
  /// let their displacements jump, and Newton's method go to and fro.
  /// @param line_load about the greatest one [N/m], > 0
  void choose_far(double line_load);

  /// From now on the contact's half-widths are those of BendingWidths, whose steps the search for
  /// the loads takes along, instead of those of the sections' own loads.
  void widen_by_bending();
  /// Of a section's contact under its load [m].
  [[nodiscard]] double half_width(Eigen::Index section, double line_load) const;

  /// Displacements under the loads, and their derivatives.
  void find_displacements(const Eigen::VectorXd& loads, Eigen::VectorXd& displacements);
  /// Of the columns of sections with a load.
  [[nodiscard]] const Eigen::MatrixXd& tangent() const { return tangent_; }

 private:
  /// Loads at their own places, and their images at the wheel's faces.
  enum class Source { load, upper_image, lower_image };
  static constexpr std::array<Source, 3> sources{Source::load, Source::upper_image,
                                                 Source::lower_image};

  [[nodiscard]] double place_of(Source source, Eigen::Index j) const;
  [[nodiscard]] double share_of(Source source) const;
  void append_pin(const PinLine& pin, const SectionEdges& edges);
  void append_wheel(const PinLine& pin);
  /// Of a load far away by its width: its logarithm, and what b^2 is multiplied with.
  struct Far {
    Eigen::MatrixXd logarithm;
    Eigen::MatrixXd by_width;  ///< [1/m^2]
  };

  [[nodiscard]] Far far_influence_of(Source source) const;
  [[nodiscard]] double square_per_load() const;
  void find_column(Eigen::Index j, double load);
  [[nodiscard]] static StripInfluence of_strip(double distance, double half);

  double modulus_;          ///< E* [Pa]
  double relative_radius_;  ///< R [m]
  double wall_half_;        ///< half of the wheel's thickness [m]
  double image_share_;      ///< of the loads' images at the wheel's faces
  Eigen::Index n_;
  Eigen::VectorXd places_;     ///< [m]
  Eigen::VectorXd widths_;     ///< [m]
  Eigen::VectorXd clearance_;  ///< [m]
  Eigen::MatrixXd slow_;       ///< displacement by line load of beam, cylinder and plate [m^2/N]
  Eigen::MatrixXd fast_;       ///< the same of half-spaces
  Eigen::MatrixXd tangent_;    ///< d displacement/d line load of all
  std::vector<Far> far_;       ///< by source
  double far_distance_ = 0.;   ///< from a load on [m]
  std::optional<BendingWidths> bending_;
};

}  // namespace geneva::loads
