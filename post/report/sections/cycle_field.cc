#include "post/report/sections/cycle_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "base/errors.h"
#include "base/json_values.h"
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
<label>{} <input type="range" name="instant" min="0" max="{}" value="{}"></label>
<button type="button" name="play" aria-pressed="false">Play</button>
</div>
)";

/// One picture of what is played.
struct PlayedInstant {
  double driver_angle;  ///< [rad]; not a number without a mechanism
  double in_charts;     ///< its x in the charts
  std::string words;
};

/// A series of fields, and the one that is shown first.
struct Played {
  std::string control;  ///< "Instant"
  std::vector<PlayedInstant> instants;
  std::size_t first;
  double half_width;  ///< greatest of the contact, in output units, > 0
  std::string frame;  ///< of the first picture, in words
  std::string more;   ///< HTML of a picture before the others
};

/// "driver angle -19.947 deg, driving wall: pin force 437.7 N, peak pressure 340.07 MPa".
std::string words_of_instant(const json& instant, const UnitSystem units) {
  return fmt::format(
      "driver angle {}, {} wall: pin force {}, peak pressure {}",
      shown_with_unit(instant.at("driver_angle"), Dimension::angle, units),
      instant.at("wall").get<std::string>(),
      shown_with_unit(instant.at("pin_force"), Dimension::force, units),
      shown_with_unit(instant.at("contact").at("peak_pressure"), Dimension::stress, units));
}

std::string legend(const CycleFrames& frames, const std::string& unit) {
  constexpr std::size_t bar_letters = 26;  // below a picture on paper
  std::string colours;
  for (const std::string& colour : palette()) colours += ", #" + colour;
  std::string ticks;
  for (const double at : numbers_that_fit(frames.range[0], frames.range[1], 3, 4, bar_letters))
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
json frames_data(const Played& played, const CycleFrames& whole, const CycleFrames& contact) {
  json frames = json::array();
  for (std::size_t i = 0; i < played.instants.size(); ++i) {
    const PlayedInstant& instant = played.instants[i];
    frames.push_back({{"driver_angle", instant.driver_angle},
                      {"shown_angle", instant.in_charts},
                      {"words", instant.words},
                      {"wheel", whole.images[i]},
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

/// The instants that have a field, in the order of the fields.
Played instants_played(const json& cycle, const UnitSystem units) {
  Played played{"Instant", {}, 0, 0., "in the wheel's frame, ", mechanism_figure};
  for (const json& instant : cycle.at("instants")) {
    const json& contact = instant.at("contact");
    if (contact.is_null()) continue;
    if (instant == cycle.at("greatest")) played.first = played.instants.size();
    const json& angle = instant.at("driver_angle");
    played.instants.push_back({number_of(angle), in_units(angle, Dimension::angle, units),
                               words_of_instant(instant, units)});
    played.half_width =
        std::max(played.half_width, in_units(contact.at("half_width"), Dimension::length, units));
  }
  return played;
}

/// "load step 3 of 12, 0.25 s: peak pressure 340.07 MPa".
std::string words_of_step(const json& step, const std::size_t of, const UnitSystem units) {
  double greatest = 0.;
  for (const json& contact : step.at("contacts"))
    greatest = std::max(greatest, number_of(contact.at("peak_pressure")));
  return fmt::format(
      "load step {} of {}, {}: peak pressure {}", step.at("step").get<int>(), of,
      shown_with_unit(step.at("time"), Dimension::time, units),
      shown_with_unit(base::quantity(greatest, Dimension::stress), Dimension::stress, units));
}

Played steps_played(const json& history, const UnitSystem units) {
  const json& steps = history.at("steps");
  Played played{
      "Load step",         {}, history.at("greatest").at("step").get<std::size_t>() - 1, 0.,
      "the whole model, ", ""};
  for (const json& step : steps) {
    played.instants.push_back({std::numeric_limits<double>::quiet_NaN(),
                               step.at("step").get<double>(),
                               words_of_step(step, steps.size(), units)});
    for (const json& contact : step.at("contacts"))
      played.half_width =
          std::max(played.half_width, in_units(contact.at("half_width"), Dimension::length, units));
  }
  return played;
}

CycleField field_of(const json& view, const Played& played) {
  const auto [whole, contact] = cycle_pictures(view, played.half_width);
  if (played.instants.size() != whole.images.size())
    throw base::InputError(
        "the fields to play and the document that they belong to differ in number");
  const auto wide = [&](const CycleFrames& frames) {
    return fmt::format("{} {} wide", significant(frames.size[0], 3),
                       escaped(view.at("length_unit")));
  };
  const std::string stress = view.at("stress_unit");
  const std::string html =
      fmt::format(fmt::runtime(field_controls), played.control, played.instants.size() - 1,
                  played.first) +
      fmt::format(
          "<p id=\"cycle-words\" class=\"status\">{}</p>\n<div class=\"instant\">\n{}{}{}</div>\n",
          escaped(played.instants[played.first].words), played.more,
          frame_figure("cycle-wheel", whole, played.first,
                       played.frame + wide(whole) + "; more at the contact", stress),
          frame_figure("cycle-contact", contact, played.first,
                       "around the contact, " + wide(contact), stress));
  return {html, frames_data(played, whole, contact)};
}

}  // namespace

CycleField cycle_field(const ResultsDirectory& results) {
  for (const auto& [name, played_of] :
       {std::pair{"cycle", &instants_played}, std::pair{"load_steps", &steps_played}}) {
    const json* const document = results.document(name);
    const json* const view = results.document(std::string(name) + "_view");
    if (document == nullptr || view == nullptr || document->at("greatest").is_null()) continue;
    return field_of(*view, played_of(*document, results.units()));
  }
  return {};
}

}  // namespace geneva::post
