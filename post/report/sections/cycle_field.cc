#include "post/report/sections/cycle_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/errors.h"
#include "post/report/html/html.h"
#include "post/report/html/shown_values.h"
#include "post/report/pictures/cycle_frames.h"
#include "post/report/pictures/picture.h"
#include "post/report/sections/limits.h"

namespace geneva::post {

using base::Dimension;
using base::UnitSystem;
using nlohmann::json;

namespace {

constexpr const char* field_controls = R"(<div id="cycle-controls" class="controls">
<label>Instant <input type="range" name="instant" min="0" max="{}" value="{}"></label>
<button type="button" name="play" aria-pressed="false">Play</button>
</div>
)";

/// The instants that have a field, in the order of the fields.
std::vector<const json*> solved_instants(const json& cycle) {
  std::vector<const json*> solved;
  for (const json& instant : cycle.at("instants"))
    if (!instant.at("contact").is_null()) solved.push_back(&instant);
  return solved;
}

double greatest_half_width(const json& cycle, const UnitSystem units) {
  double greatest = 0.;
  for (const json& instant : cycle.at("instants"))
    if (!instant.at("contact").is_null())
      greatest = std::max(
          greatest, in_units(instant.at("contact").at("half_width"), Dimension::length, units));
  return greatest;
}

/// "driver angle -19.947 deg, driving wall: pin force 437.7 N, peak pressure 340.07 MPa".
std::string words_of(const json& instant, const UnitSystem units) {
  return fmt::format(
      "driver angle {}, {} wall: pin force {}, peak pressure {}",
      shown_with_unit(instant.at("driver_angle"), Dimension::angle, units),
      instant.at("wall").get<std::string>(),
      shown_with_unit(instant.at("pin_force"), Dimension::force, units),
      shown_with_unit(instant.at("contact").at("peak_pressure"), Dimension::stress, units));
}

std::string legend(const CycleFrames& frames, const std::string& unit) {
  std::string colours;
  for (const std::string& colour : palette()) colours += ", #" + colour;
  std::string ticks;
  for (const double at : round_numbers(frames.range[0], frames.range[1], 5))
    ticks += fmt::format("<span style=\"left: {:.2f}%\">{}</span>",
                         100. * (at - frames.range[0]) / (frames.range[1] - frames.range[0]),
                         significant(at, 4));
  return fmt::format(
      "<div class=\"legend\"><span class=\"unit\">von Mises stress [{}]</span><div class=\"bar\" "
      "style=\"background: linear-gradient(to right{})\"></div><div "
      "class=\"ticks\">{}</div></div>\n",
      escaped(unit), colours, ticks);
}

std::string frame_figure(const std::string& id, const CycleFrames& frames, const std::size_t first,
                         const std::string& caption, const std::string& unit) {
  return fmt::format(
      "<figure>\n<img id=\"{}\" alt=\"von Mises stress {}\" "
      "src=\"data:image/png;base64,{}\">\n{}<figcaption>{}</figcaption>\n</figure>\n",
      id, caption, frames.images[first], legend(frames, unit), caption);
}

/// What the script shows of each instant.
json frames_data(const std::vector<const json*>& instants, const CycleFrames& wheel,
                 const CycleFrames& contact, const UnitSystem units) {
  json frames = json::array();
  for (std::size_t i = 0; i < instants.size(); ++i) {
    const json& angle = instants[i]->at("driver_angle");
    frames.push_back({{"driver_angle", number_of(angle)},
                      {"shown_angle", in_units(angle, Dimension::angle, units)},
                      {"words", words_of(*instants[i], units)},
                      {"wheel", wheel.images[i]},
                      {"contact", contact.images[i]}});
  }
  return frames;
}

constexpr const char* mechanism_figure =
    R"(<figure>
<svg viewBox="0 0 640 490" role="img" aria-label="the mechanism at the instant"><use href="#mechanism-drawing" width="640" height="490"/></svg>
<figcaption>the mechanism</figcaption>
</figure>
)";

}  // namespace

CycleField cycle_field(const ResultsDirectory& results) {
  const json* const view = results.document("cycle_view");
  const json* const cycle = results.document("cycle");
  if (view == nullptr || cycle == nullptr || cycle->at("greatest").is_null()) return {};
  const UnitSystem units = results.units();
  const CycleFrames wheel = wheel_frames(*view);
  const CycleFrames contact = contact_frames(*view, greatest_half_width(*cycle, units));
  const std::vector<const json*> instants = solved_instants(*cycle);
  if (instants.size() != wheel.images.size())
    throw base::InputError("cycle_view.json and cycle.json differ in the number of instants");
  const auto greatest =
      std::find_if(instants.begin(), instants.end(),
                   [&](const json* const instant) { return *instant == cycle->at("greatest"); });
  const auto first = static_cast<std::size_t>(greatest - instants.begin()) % instants.size();
  const auto wide = [&](const CycleFrames& frames) {
    return fmt::format("{} {} wide", significant(frames.size[0], 3),
                       escaped(view->at("length_unit")));
  };
  const std::string stress = view->at("stress_unit");
  const std::string html =
      fmt::format(fmt::runtime(field_controls), instants.size() - 1, first) +
      fmt::format(
          "<p id=\"cycle-words\" class=\"status\">{}</p>\n<div class=\"instant\">\n{}{}{}</div>\n",
          escaped(words_of(*instants[first], units)), mechanism_figure,
          frame_figure("cycle-wheel", wheel, first,
                       "in the wheel's frame, " + wide(wheel) + "; more at the contact", stress),
          frame_figure("cycle-contact", contact, first, "around the contact, " + wide(contact),
                       stress));
  return {html, frames_data(instants, wheel, contact, units)};
}

}  // namespace geneva::post
