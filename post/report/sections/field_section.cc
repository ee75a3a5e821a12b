#include "post/report/sections/field_section.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "post/report/html/html.h"
#include "post/report/pictures/field_picture.h"

namespace geneva::post {

namespace {

constexpr const char* cut_control = R"(<label>Cut <select name="cut">
<option value="across">across, at the maximum {0}</option>
<option value="along">along, at the maximum {0}</option>
<option value="none">none</option>
</select></label>
)";
constexpr const char* parts_by_contact = R"(<option value="zone">contact zone</option>
<option value="model">whole model</option>)";
constexpr const char* parts_without_contact = R"(<option value="model">whole model</option>
<option value="zone">around the maximum stress</option>)";

constexpr const char* field_place = R"(<div id="field-view">
<div class="controls">
<label>Colour <select name="field"></select></label>
<label>Part <select name="part">
{}
</select></label>
{}<label>Deformation <input type="range" name="deformation" min="0" max="1" step="0.01" value="0"> <output>undeformed</output></label>
</div>
<div class="stage"></div>
<div class="legend"><span class="unit"></span><div class="bar"></div><div class="ticks"></div></div>
<p class="status" role="status">Point at the model to read a value, click to keep it below with a letter at its place, click beside the model to clear; drag it, or press arrows, plus, minus and Home.</p>
<ul class="kept" aria-label="values kept"></ul>
</div>
)";

bool is_on_contact(const nlohmann::json& view) { return view.at("focus") == "contact"; }

std::string interactive_part(const nlohmann::json& view) {
  const bool has_contact = is_on_contact(view);
  const std::string cut =
      view.at("dimension") == 3
          ? fmt::format(fmt::runtime(cut_control), has_contact ? "pressure" : "stress")
          : "";
  return fmt::format(fmt::runtime(field_place),
                     has_contact ? parts_by_contact : parts_without_contact, cut);
}

/// What the numbers in the pictures stand for.
std::string list_of_marks(const nlohmann::json& view) {
  if (view.at("marks").empty()) return "";
  std::string items;
  for (const nlohmann::json& mark : view.at("marks")) {
    std::string titles;
    for (const nlohmann::json& title : mark.at("titles"))
      titles += (titles.empty() ? "" : "; ") + escaped(title.get<std::string>());
    items += fmt::format("<li>{}</li>\n", titles);
  }
  return fmt::format("<p>Places of the maximum stresses{}:</p>\n<ol class=\"marks\">\n{}</ol>\n",
                     is_on_contact(view) ? " outside the contact's own field" : "", items);
}

std::string figure(const std::string& style, const std::string& picture,
                   const std::string& caption) {
  return fmt::format(
      "<figure class=\"{}\">\n{}<figcaption>von Mises stress {}</figcaption>\n</figure>\n", style,
      picture, caption);
}

}  // namespace

PicturePart main_part(const nlohmann::json& view) {
  return is_on_contact(view) ? PicturePart::contact : PicturePart::model;
}

FieldPictures field_pictures(const nlohmann::json& view) {
  FieldPictures pictures;
  if (is_on_contact(view)) pictures.contact = field_picture(view, PicturePart::contact);
  if (view.at("dimension") == 2 || !is_on_contact(view))
    pictures.model = field_picture(view, PicturePart::model);
  return pictures;
}

std::string field_section(const nlohmann::json& view, const FieldPictures& pictures,
                          const bool is_interactive) {
  const std::string style = is_interactive ? "still" : "picture";
  const bool is_space = view.at("dimension") == 3;
  std::string content = is_interactive ? interactive_part(view) : "";
  if (pictures.contact)
    content += figure(
        style, *pictures.contact,
        fmt::format("around the contact{}",
                    is_space ? ", in the cut across it where the pressure is greatest" : ""));
  if (pictures.model)
    content +=
        figure(pictures.contact ? "picture" : style, *pictures.model,
               is_space ? "in the cut through the place of its maximum" : "in the whole model");
  return html_section("field", "Stress field", content + list_of_marks(view));
}

}  // namespace geneva::post
