#pragma once

#include <cstddef>
#include <vector>

#include "post/analysis/contact_frame.h"
#include "post/analysis/contact_section.h"
#include "post/analysis/stress.h"

namespace geneva::post {

/// The sections through all layers of contact nodes with one in contact, by ascending z; none if
/// the contact does not extend along z or its nodes stand in no layers. Beyond a plane of symmetry
/// z = const they are mirrored.
std::vector<ContactSection> contact_sections(const fem::Solution<3>& solution,
                                             const fem::ContactResult<3>& contact,
                                             const ContactFrame& frame,
                                             const std::vector<CellStress<3>>& cells);

/// Nodes in contact in the layer that is nearest to the middle of the surfaces' length.
std::size_t nodes_across_middle(const fem::ContactResult<3>& contact, const ContactFrame& frame);

/// Maximum shear stress of a body below the contact and its depth.
struct ShearBelow {
  double value;  ///< [Pa]
  double depth;  ///< [m]
};

/// Down to three half-widths, and twice the half-width to both sides.
ShearBelow maximum_shear(const fem::Solution<3>& solution, const ContactFrame& frame,
                         double half_width, const std::vector<CellStress<3>>& cells);

/// The section in the middle of the surfaces' length, between its two neighbours: of a bent or
/// tilted pin they differ. Where the middle is not loaded, the loaded section next to it.
/// @throws base::InputError if there is none
ContactSection middle_section(const fem::ContactResult<3>& contact, const ContactFrame& frame,
                              const std::vector<ContactSection>& sections);

/// The line load in the middle of the surfaces' length and at its more heavily loaded end [N/m].
struct LineLoad {
  double middle;
  double end;

  [[nodiscard]] double ratio() const { return middle > 0. ? end / middle : 0.; }
};
LineLoad line_load(const fem::ContactResult<3>& contact, const ContactFrame& frame,
                   const std::vector<ContactSection>& sections);

}  // namespace geneva::post
