#include "post/report/pictures/cycle_frames.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/base64.h"
#include "base/errors.h"
#include "post/report/pictures/picture.h"
#include "post/view/quantised.h"

namespace geneva::post {

using nlohmann::json;

namespace {

constexpr int wheel_pixels = 400;
constexpr int contact_pixels = 280;

/// The field of an instant, in output units.
struct Frame {
  std::vector<float> points;  ///< x and y of each
  std::vector<float> values;
  std::vector<std::uint32_t> cells;  ///< four points of each, in lexicographic order

  [[nodiscard]] std::size_t n_points() const { return values.size(); }
  /// Place of the greatest stress.
  [[nodiscard]] std::array<double, 2> greatest() const {
    const auto at =
        static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
    return {points[2 * at], points[2 * at + 1]};
  }
};

Frame frame_of(const json& instant) {
  Frame frame{base::decoded<float>(instant.at("points")),
              restored({instant.at("low"), instant.at("high"),
                        base::decoded<std::uint16_t>(instant.at("steps").get<std::string>())}),
              base::decoded<std::uint32_t>(instant.at("cells"))};
  const bool is_whole = frame.points.size() == 2 * frame.n_points() && frame.n_points() > 0 &&
                        frame.cells.size() % 4 == 0 &&
                        std::all_of(frame.cells.begin(), frame.cells.end(),
                                    [&](const auto point) { return point < frame.n_points(); });
  if (!is_whole)
    throw base::InputError("the fields to play are damaged: points and cells do not fit");
  return frame;
}

std::vector<Frame> frames_of(const json& view) {
  std::vector<Frame> frames;
  for (const json& instant : view.at("instants")) frames.push_back(frame_of(instant));
  if (frames.empty()) throw base::InputError("the fields to play are damaged: it has no instants");
  return frames;
}

/// A rectangle of the slot's frame.
struct FrameWindow {
  std::array<double, 2> middle;
  double pixels;  ///< per unit of length
  int width;
  int height;
};

std::string painted_frame(const Frame& frame, const FrameWindow& window,
                          const std::array<double, 2>& range) {
  Picture picture(window.width, window.height, {255, 255, 255});
  const auto corner = [&](const std::size_t point) {
    return Picture::Corner{
        0.5 * window.width + window.pixels * (frame.points[2 * point] - window.middle[0]),
        0.5 * window.height - window.pixels * (frame.points[2 * point + 1] - window.middle[1]),
        (frame.values[point] - range[0]) / (range[1] - range[0])};
  };
  for (std::size_t i = 0; i + 3 < frame.cells.size(); i += 4) {
    const auto at = [&](const std::size_t k) { return corner(frame.cells[i + k]); };
    picture.paint({at(0), at(1), at(2)});
    picture.paint({at(1), at(3), at(2)});
  }
  return base::encoded_bytes(picture.png());
}

/// Least and greatest coordinate of all frames along an axis.
std::array<double, 2> extent(const std::vector<Frame>& frames, const std::size_t axis) {
  std::array<double, 2> ends{std::numeric_limits<double>::max(),
                             std::numeric_limits<double>::lowest()};
  for (const Frame& frame : frames)
    for (std::size_t i = axis; i < frame.points.size(); i += 2) {
      ends[0] = std::min<double>(ends[0], frame.points[i]);
      ends[1] = std::max<double>(ends[1], frame.points[i]);
    }
  return ends;
}

/// Of the stresses farther than that from the greatest one of each frame.
std::array<double, 2> range_beyond(const std::vector<Frame>& frames, const double distance) {
  double greatest = 0.;
  for (const Frame& frame : frames) {
    const auto middle = frame.greatest();
    for (std::size_t i = 0; i < frame.n_points(); ++i)
      if (std::hypot(frame.points[2 * i] - middle[0], frame.points[2 * i + 1] - middle[1]) >=
          distance)
        greatest = std::max<double>(greatest, frame.values[i]);
  }
  return {0., greatest > 0. ? greatest : 1.};
}

CycleFrames whole_frames(const std::vector<Frame>& frames) {
  constexpr double margin = 1.04;
  constexpr double left_out = 0.05;  // of the wheel's size, around the contact
  const auto x = extent(frames, 0);
  const auto y = extent(frames, 1);
  const double size = margin * std::max(x[1] - x[0], y[1] - y[0]);
  const FrameWindow window{
      {0.5 * (x[0] + x[1]), 0.5 * (y[0] + y[1])}, wheel_pixels / size, wheel_pixels, wheel_pixels};
  CycleFrames result{range_beyond(frames, left_out * size), {size, size}, {}};
  for (const Frame& frame : frames)
    result.images.push_back(painted_frame(frame, window, result.range));
  return result;
}

CycleFrames contact_frames(const std::vector<Frame>& frames, const double half_width) {
  constexpr double half_widths_wide = 10.;
  const double size = half_widths_wide * half_width;
  CycleFrames result{range_beyond(frames, 0.), {size, size}, {}};
  for (const Frame& frame : frames)
    result.images.push_back(painted_frame(
        frame, {frame.greatest(), contact_pixels / size, contact_pixels, contact_pixels},
        result.range));
  return result;
}

}  // namespace

CyclePictures cycle_pictures(const json& view, const double half_width) {
  const std::vector<Frame> frames = frames_of(view);
  return {whole_frames(frames), contact_frames(frames, half_width)};
}

}  // namespace geneva::post
