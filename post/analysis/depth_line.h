#pragma once

#include <optional>
#include <vector>

#include "post/analysis/closed_form.h"
#include "post/analysis/stress.h"

namespace geneva::post {

/// Stress in the frame of a plane contact, tension positive [Pa].
struct ContactStress {
  double along;         ///< normal stress along the contact
  double across;        ///< normal stress across it, along the depth
  double out_of_plane;  ///< normal stress along the thickness, or around the axis
  double shear;         ///< maximum shear in the plane
};

/// Stress below the centre of a contact.
struct DepthSample {
  double depth;  ///< [m], into the target
  ContactStress computed;
  std::optional<ContactStress> closed_form;  ///< McEwen's, of line contacts
};

/// The recovered stress on the line from a contact's centre of pressure into the target, down to
/// four half-widths; all ranks get the samples.
std::vector<DepthSample> depth_line(const fem::Solution<2>& solution,
                                    const fem::ContactResult<2>& contact,
                                    const PressureCentre& centre,
                                    const std::optional<ClosedForm>& hertz,
                                    const NodalStress<2>& stress);

}  // namespace geneva::post
