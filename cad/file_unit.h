#pragma once

namespace geneva::cad {

/// Unit of length of a file for CAD systems.
enum class FileUnit { millimetre, inch };

/// One of it in metres.
constexpr double metres(const FileUnit unit) {
  return unit == FileUnit::millimetre ? 1e-3 : 25.4e-3;
}

}  // namespace geneva::cad
