#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/units.h"
#include "loads/design/johnson.h"
#include "loads/drawing/mechanism_drawing.h"
#include "loads/motion/drive.h"
#include "loads/motion/mechanism.h"
#include "loads/wheel/geneva_dimensions.h"
#include "loads/wheel/internal_dimensions.h"
#include "model/input/case_values.h"
#include "model/input/parameters.h"

namespace geneva::model {

/// A wheel of which the whole outline is known.
using DrawnWheel = std::variant<loads::GenevaDimensions, loads::InternalDimensions>;

/// A type of mechanism with the sizes that it alone has: what a case, its analysis and its picture
/// need to know of it beside the sizes that all types have.
class MechanismType {
 public:
  using Sizes = loads::GenevaDimensionsInput;

  MechanismType() = default;
  MechanismType(const MechanismType&) = delete;
  MechanismType& operator=(const MechanismType&) = delete;
  virtual ~MechanismType() = default;

  /// @throws base::InputError where the loads room does
  [[nodiscard]] virtual loads::Mechanism mechanism(const Sizes& sizes) const = 0;

  /// Whether there is a whole wheel to draw.
  [[nodiscard]] virtual bool is_drawn() const { return false; }
  /// None if it is not drawn.
  /// @throws base::InputError if its dimensions do not fit together
  [[nodiscard]] virtual std::optional<DrawnWheel> drawn_wheel(const Sizes& /*sizes*/) const {
    return std::nullopt;
  }
  /// Whether it is the mechanism of Johnson's equations.
  [[nodiscard]] virtual bool is_johnsons() const { return false; }
  /// For laws of motion that are given on the cross; none if there can be none.
  [[nodiscard]] virtual std::optional<loads::PlaneGeneva> plane() const { return std::nullopt; }

  /// What follows from its sizes without being asked for, in words.
  [[nodiscard]] virtual std::vector<std::string> notices(const Sizes& /*sizes*/,
                                                         base::UnitSystem /*units*/) const {
    return {};
  }
  /// Lengths [m] that it alone has, by name.
  [[nodiscard]] virtual std::vector<std::pair<std::string, double>> lengths() const { return {}; }
  /// Where the driver's axis is, of types whose wheel is not drawn; none if it has no single one.
  [[nodiscard]] virtual std::optional<loads::Place> driver_axis() const { return std::nullopt; }
  /// The linkage that carries the pin, by the driver angle from the middle of its engagement; none
  /// if there is none.
  [[nodiscard]] virtual std::function<loads::Polyline(double)> linkage(
      const Sizes& /*sizes*/) const {
    return nullptr;
  }
};

/// How a case gives a type of mechanism.
struct MechanismKind {
  std::string name;                        ///< value of 'Type'
  std::string help;                        ///< of that value
  std::vector<std::string> sizes;          ///< exactly one of them is given, if there are any
  std::vector<std::string> more_sizes;     ///< that may be given
  std::vector<std::string> unused;         ///< lengths that have no effect with it
  std::vector<Parameter> parameters;       ///< that it alone has
  std::vector<std::string> needed;         ///< those of them that are to be given
  SectionPath section{names::mechanism};   ///< of them
  std::optional<std::string> responsible;  ///< parameter for which a mechanism is refused
  std::function<std::shared_ptr<const MechanismType>(const CaseValues&,
                                                     const MechanismType::Sizes&)>
      read;
};

/// All types; the first is the default.
const std::vector<MechanismKind>& mechanism_kinds();

/// @param name of one of them
const MechanismKind& mechanism_kind(const std::string& name);

MechanismKind external_kind();
MechanismKind internal_kind();
MechanismKind spherical_kind();
MechanismKind long_dwell_kind();
MechanismKind four_bar_kind();

/// Lengths of a drawing that types without a drawn wheel have no use for.
std::vector<std::string> lengths_of_drawings();

/// Crank radius [m] of a plane mechanism, from whichever size is given: r = (D/2) tan(pi/n),
/// c = r/sin(pi/n).
double crank_radius(const MechanismType::Sizes& sizes);
double centre_distance(const MechanismType::Sizes& sizes);

}  // namespace geneva::model
