#include "model/input/motion_table.h"

#include <array>
#include <utility>

#include "model/input/column_file.h"

namespace geneva::model {

MotionTable read_motion_table(const std::filesystem::path& file) {
  auto [times, angles] =
      read_two_columns(file, {{{"time", base::Dimension::time}, {"angle", base::Dimension::angle}}},
                       "time [s], angle [deg]");
  return {std::move(times), std::move(angles)};
}

}  // namespace geneva::model
