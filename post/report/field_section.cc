#include "post/report/field_section.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "post/report/html.h"

namespace geneva::post {

namespace {

constexpr const char* cut_control = R"(<label>Cut <select name="cut">
<option value="across">across, at the maximum pressure</option>
<option value="along">along, at the maximum pressure</option>
<option value="none">none</option>
</select></label>
)";

constexpr const char* field_place = R"(<div id="field-view">
<div class="controls">
<label>Colour <select name="field"></select></label>
<label>Part <select name="part">
<option value="zone">contact zone</option>
<option value="model">whole model</option>
</select></label>
{}<label>Deformation <input type="range" name="deformation" min="0" max="1" step="0.01" value="0"> <output>undeformed</output></label>
</div>
<div class="stage"></div>
<div class="legend"><span class="unit"></span><div class="bar"></div><div class="ticks"></div></div>
<p class="status" role="status">Point at the model to read a value; drag it, or press arrows, plus, minus and Home.</p>
</div>
)";

}  // namespace

std::string field_section(const nlohmann::json& view, const std::string& picture,
                          const bool is_interactive) {
  const bool is_space = view.at("dimension") == 3;
  std::string content =
      is_interactive ? fmt::format(fmt::runtime(field_place), is_space ? cut_control : "") : "";
  content += fmt::format(
      "<figure class=\"{}\">\n{}<figcaption>von Mises stress around the contact{}</figcaption>\n"
      "</figure>\n",
      is_interactive ? "still" : "picture", picture,
      is_space ? ", in the cut across it where the pressure is greatest" : "");
  return html_section("field", "Stress field", content);
}

}  // namespace geneva::post
