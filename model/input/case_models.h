#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/input/case_file.h"
#include "model/input/case_values.h"
#include "model/mechanism_motion.h"

namespace geneva::model {

/// Reads the subsection Mechanism.
/// @throws base::InputError if values contradict each other or make no mechanism, or if the
/// motion table is missing, outside of the case directory or no table
MechanismCase read_mechanism(const CaseValues& values, const std::filesystem::path& directory);

/// What `geneva optimise` looks for; nothing if the case leaves no dimension free.
/// @throws base::InputError for bounds that are none, a dimension that is free twice, and a goal or
/// limit that the mechanism does not have
std::optional<OptimisationCase> read_optimisation(const CaseValues& values,
                                                  const MechanismCase& mechanism);

/// Reads where the crank holds the pin.
/// @throws base::InputError for a root gap without a root
PinHolding read_pin_holding(const CaseValues& values);

/// Reads the rest of the subsection Pin of Mechanism.
/// @throws base::InputError if values contradict each other, or the profile's file is missing,
/// outside of the case directory or no table
PinCase read_pin(const CaseValues& values, PinHolding::Hold hold,
                 const std::filesystem::path& directory);

/// Refuses a pin that does not fit: one that ends within the slot, or touches its other wall.
/// @param slot_width [m]; none for a block, which has no other wall
void check_pin(const CaseValues& values, const MechanismCase& given, const MechanismSizes& sizes,
               std::optional<double> slot_width);

/// Refuses values of the subsection Pin that a plane model does not know.
void check_no_pin(const CaseValues& values);

/// Reads the subsection Design of Mechanism.
/// @throws base::InputError if the shaft cannot be understood, or a value has no effect
/// without one
DesignCase read_design(const CaseValues& values);

/// Reads the subsection Geometry.
/// @param dimension 2 or 3
/// @throws base::InputError if values contradict each other or the file is missing or outside
/// of the case directory
GeometryCase read_geometry_case(const CaseValues& values, const std::filesystem::path& directory,
                                int dimension);

/// What a geometry case may set depends on its own lists: the names of its bodies and loads, and
/// the file found in its directory.
/// @throws base::InputError if a list has an empty or a double name, or without a file's name
/// none or two are found
std::vector<Parameter> geometry_parameters_of(const ParameterText& text,
                                              const std::filesystem::path& directory);

/// Reads the subsection Synthesis.
/// @throws base::InputError if a value is missing, has no effect with the kind of synthesis,
/// contradicts another one, or the points are missing, outside of the case directory or no table
SynthesisCase read_synthesis(const CaseValues& values, const std::filesystem::path& directory);

}  // namespace geneva::model
