#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/json_values.h"
#include "base/units.h"
#include "fem/problem/problem.h"
#include "fem/problem/settings.h"
#include "loads/allowables.h"
#include "loads/design/design.h"
#include "loads/design/shaft.h"
#include "loads/motion/drive.h"
#include "loads/motion/pin_load.h"
#include "loads/pin/pin_profile.h"
#include "loads/synthesis/crank_rocker.h"
#include "loads/synthesis/path_synthesis.h"
#include "loads/synthesis/quick_return.h"
#include "loads/wheel/geneva_dimensions.h"
#include "mesh/pick.h"
#include "model/input/materials.h"
#include "model/input/optimisation_case.h"
#include "model/input/parameter_text.h"
#include "model/input/parameters.h"
#include "model/mechanisms/mechanism_type.h"

namespace geneva::model {

/// A material as the case file gives it, SI units.
struct CaseMaterial {
  double youngs_modulus;
  double poissons_ratio;
  double density;
};

/// How the driver moves.
struct DriverMotion {
  enum class Kind { constant, table, law_on_carrier, law_on_cross };

  Kind kind;
  double speed;         ///< > 0 [rad/s] at driver angle 0, if constant
  double acceleration;  ///< [rad/s^2], if constant
  loads::MotionLaw law;
  double motion_time;          ///< [s] of each engagement, with a law
  std::vector<double> times;   ///< [s], of a table
  std::vector<double> angles;  ///< [rad], of a table
};

/// What `geneva design` wants to know besides the mechanism.
struct DesignCase {
  loads::GivenLengths given_lengths;
  std::optional<loads::Shaft> shaft;
  bool adds_shaft_inertia;                 ///< to the load's
  std::optional<double> amplitude_radius;  ///< [m]
};

/// Where the crank holds the pin.
struct PinHolding {
  enum class Hold { one_end, both_ends, core };

  Hold hold;
  std::optional<double> root_gap;       ///< [m]
  std::optional<double> bore_diameter;  ///< of a hollow pin [m]
};

/// The pin along its length, of a mechanism in 3-D.
struct PinCase {
  enum class Profile { cylindrical, crown, logarithmic, table };

  std::optional<double> overhang;  ///< [m]
  std::optional<double> length;    ///< [m]
  double end_chamfer;              ///< [m]
  Profile profile;
  double crown_radius;                      ///< [m]
  std::optional<double> profile_load;       ///< [N]
  std::optional<double> profile_amplitude;  ///< [m]
  std::optional<double> profile_length;     ///< [m]
  loads::ProfileTable table;
  double tilt;            ///< [rad]
  double tilt_tolerance;  ///< by which it may be more or less [rad], >= 0
  std::optional<std::pair<double, double>> load_range;  ///< least and greatest pin force [N]
  loads::EdgeBreak slot_edge;
};

/// Model = mechanism: a Geneva wheel and its pin.
struct MechanismCase {
  enum class AngleKind { at_maximum_wheel_acceleration, at_maximum_pin_force, given };
  enum class InertiaKind { from_geometry, johnson, given };

  std::shared_ptr<const MechanismType> type;  ///< with the sizes that it alone has
  loads::GenevaDimensionsInput dimensions;    ///< that all types have
  int pins;                                   ///< equally spaced, unless angles are given
  std::vector<double> pin_angles;             ///< [rad], may be empty
  DriverMotion motion;
  loads::WheelLoad load;
  double external_torque;                   ///< on the wheel, against its motion if positive [N m]
  double slot_friction;                     ///< coefficient, of a pin fixed to its carrier
  std::optional<loads::RollerBore> roller;  ///< none: the pin is fixed to its carrier
  std::optional<double> bore_clearance;     ///< of a roller [m]; none: its bore is not modelled
  AngleKind angle_kind;
  double driver_angle;  ///< [rad], if given
  InertiaKind inertia_kind;
  double wheel_inertia;               ///< [kg m^2], if given
  bool is_local;                      ///< pin on a block of slot wall instead of the whole wheel
  std::optional<double> block_width;  ///< [m]
  std::optional<double> block_depth;  ///< [m]
  CaseMaterial pin;
  CaseMaterial stud;  ///< of a roller
  CaseMaterial wheel;
  PinHolding pin_holding;
  std::optional<PinCase> space;     ///< none with Dimension = 2
  std::optional<int> instants;      ///< of a cycle, over each engagement; none: as many as needed
  std::optional<double> pin_force;  ///< [N] in place of the motion's; not of the case file
  /// The mirror image about the slot's axis, in which the braking wall is the driving one; not of
  /// the case file.
  bool is_mirrored = false;
  DesignCase design;
};

/// A file of the user's, and how it is to be read.
struct GeometryFile {
  std::filesystem::path file;       ///< .geo, .msh or .step file in the case directory
  double length_unit;               ///< metres per unit of the file
  double circle_tolerance;          ///< distance of nodes from their circle over its radius
  std::vector<mesh::Pick> picks;    ///< names for places of a STEP file
  std::optional<double> cell_size;  ///< of its coarse cells [m]
};

/// Model = geometry: the user's own geometry.
struct GeometryCase : GeometryFile {
  std::variant<fem::Problem<2>, fem::Problem<3>> problem;  ///< by the dimension
};

/// A path generator wanted, and the file in the case directory that holds its points.
struct PathCase {
  std::filesystem::path file;
  loads::PathTask task;
};

/// Model = synthesis: dimensions of a linkage wanted.
using SynthesisCase = std::variant<loads::QuickReturnInput, loads::CrankRockerInput, PathCase>;

/// Whether a run leaves what it needs to be continued.
enum class Checkpoints {
  automatic,  ///< in 3-D, once it takes a while
  always,
  never
};

/// Everything that a case directory asks for, SI units; it has exactly one of the three models.
struct Case {
  std::filesystem::path directory;
  ParameterText text;  ///< as it is written
  std::string title;
  std::string project;
  std::string author;
  base::UnitSystem units;
  int dimension;           ///< 2 or 3
  fem::Settings settings;  ///< the defaults, if the model is a synthesis
  Checkpoints checkpoints;
  std::optional<MechanismCase> mechanism;
  std::optional<OptimisationCase> optimisation;  ///< of a mechanism
  std::optional<GeometryCase> geometry;
  std::optional<SynthesisCase> synthesis;
  std::map<std::string, KnownMaterial> materials;  ///< by body, where the case names one
  loads::Allowables allowed;
  std::optional<double> published_peak_pressure;  ///< [Pa]
  std::string published_source;
  std::vector<std::string> notices;           ///< what the text says that may not be meant
  std::string completed;                      ///< the case file with every default filled in
  std::vector<std::filesystem::path> inputs;  ///< files that the case reads, case.prm first
  std::string content;                        ///< mark of what the case is about, see content_of()
};

/// Reads case.prm of a case directory.
/// @throws base::InputError naming file, parameter, the value found and what is allowed
Case read_case(const std::filesystem::path& directory);

/// The case of that text, whose other files are in the directory.
/// @throws base::InputError as above
Case case_of(const ParameterText& text, const std::filesystem::path& directory);

/// The parameters that a case of that text may set.
/// @throws base::InputError for a model that is none, and a geometry whose names or file are wrong
std::vector<Parameter> parameters_of(const ParameterText& text,
                                     const std::filesystem::path& directory);

/// Name of the case: that of its directory, also where the user says ".".
std::string name_of(const Case& given);

/// Refuses a case for a command that is for other models.
/// @param reason what is missing there: "there is no wheel to design"
/// @param command for example "geneva design"
/// @param wanted models that it takes: "mechanism"
/// @throws base::InputError always, naming the case's model and these
[[noreturn]] void refuse_model(const Case& given, const std::string& reason,
                               const std::string& command, const std::string& wanted);

/// The whole commented parameter file, as `geneva parameters` prints it.
std::string parameter_file();

}  // namespace geneva::model
