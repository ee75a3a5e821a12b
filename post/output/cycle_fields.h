#pragma once

#include "post/output/nodal_fields.h"

namespace geneva::post {

/// The fields of one instant, of a mechanism in the frame of the engaged slot, whose axis is x; SI
/// units.
struct CycleFields {
  double when;          ///< driver angle [rad], without a mechanism the number of the load step
  double pin_distance;  ///< of the pin's axis from the wheel's [m]
  double pin_turn;      ///< psi [rad] of a pin fixed to its carrier, clockwise; see SlotMotion
  NodalFields fields;

  template <class Archive>
  void serialize(Archive& archive, const unsigned int /*version*/) {
    archive& when& pin_distance& pin_turn& fields;
  }
};

}  // namespace geneva::post
