#include "post/report/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

#include "base/errors.h"
#include "post/report/html/html.h"
#include "post/report/page_head.h"
#include "post/report/pictures/mechanism_drawing.h"
#include "post/report/pictures/picture.h"
#include "post/report/report_assets.h"
#include "post/report/sections/closed_verdict.h"
#include "post/report/sections/comparison_section.h"
#include "post/report/sections/crown_section.h"
#include "post/report/sections/cycle_field.h"
#include "post/report/sections/cycle_section.h"
#include "post/report/sections/estimate_section.h"
#include "post/report/sections/field_section.h"
#include "post/report/sections/inputs_section.h"
#include "post/report/sections/load_steps_section.h"
#include "post/report/sections/mechanism_section.h"
#include "post/report/sections/motion_section.h"
#include "post/report/sections/optimum_section.h"
#include "post/report/sections/run_section.h"
#include "post/report/sections/sweep_section.h"
#include "post/report/sections/verdict_section.h"

namespace geneva::post {

using nlohmann::json;

namespace {

/// A script element; its text may not end the element early.
std::string script(std::string text, const std::string& attributes = "") {
  for (std::size_t at = text.find("</"); at != std::string::npos; at = text.find("</", at + 1))
    text.replace(at, 2, "<\\/");
  return fmt::format("<script{}>\n{}\n</script>\n", attributes, text);
}

std::string missing_note(const Libraries& libraries) {
  std::string text;
  for (const std::string& package : libraries.missing)
    text += fmt::format(
        "<p class=\"warning\"><strong>Note:</strong> the package {} was not installed "
        "when this report was written: parts of it are missing.</p>\n",
        escaped(package));
  return text;
}

/// What became of the inputs of a case that is varied; empty where they are those of the results.
std::string what_is_varied(const ResultsDirectory& results) {
  if (const json* const sweep = results.document("sweep"))
    return fmt::format("Of the case as it stands. The sweep replaces {}.",
                       fmt::join(sweep->at("parameters").get<std::vector<std::string>>(), ", "));
  if (results.document("optimum") != nullptr)
    return "Of the case before the search; optimum.prm is the case with what was found.";
  return "";
}

/// Of the commands that have left results, what they answer and what lies behind.
std::vector<AnsweredPart> answered_parts(const ResultsDirectory& results,
                                         const std::string& played) {
  std::vector<AnsweredPart> parts;
  if (results.document("design") != nullptr) parts.push_back(design_part(results));
  if (results.document("crown") != nullptr) parts.push_back(crown_part(results));
  if (results.document("optimum") != nullptr) parts.push_back(optimum_part(results));
  if (results.document("cycle") != nullptr) parts.push_back(cycle_part(results, played));
  if (results.document("load_steps") != nullptr) parts.push_back(load_steps_part(results, played));
  if (results.document("sweep") != nullptr) parts.push_back(sweep_part(results));
  return parts;
}

/// The answers first, then the inputs, the mechanism and what lies behind: what there is of them.
ReportPart whole_page(const ResultsDirectory& results, const std::string& field,
                      const std::string& played) {
  ReportPart page;
  const auto append = [&](const ReportPart& part) {
    page.html += part.html;
    page.charts.insert(page.charts.end(), part.charts.begin(), part.charts.end());
  };
  const bool is_run = results.document("summary") != nullptr;
  const bool is_cycle =
      results.document("cycle") != nullptr || results.document("load_steps") != nullptr;
  if (is_run) append(verdict_part(results));
  if (!is_run && !is_cycle) append(closed_verdict_part(results));
  const std::vector<AnsweredPart> answered = answered_parts(results, played);
  for (const AnsweredPart& part : answered) append(part.answer);
  append({inputs_section(results, what_is_varied(results)), {}});
  for (const AnsweredPart& part : answered) append(part.details);
  if (const json* const mechanism = results.document("mechanism"))
    append(mechanism_part(*mechanism, results.units()));
  if (results.document("estimate") != nullptr) append(estimate_part(results));
  if (results.document("kinematics") != nullptr) append(kinematics_part(results));
  if (is_run) {
    append(contact_part(results));
    append({field, {}});
    append(convergence_part(results));
    append(checks_part(results));
  }
  return page;
}

/// The drawing's data and the script that moves it.
std::string mechanism_script(json mechanism) {
  mechanism["projection"] = drawing_projection(mechanism);
  return script(mechanism.dump(), " type=\"application/json\" id=\"mechanism-data\"") +
         script(std::string(report_assets::mechanism));
}

std::string page(const std::string& title, const std::string& header, const ReportPart& part,
                 const Libraries& libraries, const std::string& more_scripts) {
  json charts = json::array();
  for (const Chart& chart : part.charts) charts.push_back(to_json(chart));
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
      "name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n"
      "<style>\n{}\n</style>\n</head>\n<body{}>\n",
      escaped(title), report_assets::style, libraries.charts ? "" : " class=\"no-charts\"");
  text += header + "<main>\n" + missing_note(libraries) + part.html + "</main>\n";
  text += script(std::string(report_assets::numbers));
  if (libraries.charts) {
    text += script(charts.dump(), " type=\"application/json\" id=\"charts\"");
    text += script(*libraries.charts) + script(std::string(report_assets::charts));
  }
  return text + more_scripts + "</body>\n</html>\n";
}

/// The view's data and the script that draws it.
std::string field_script(const json& view, const std::string& graphics) {
  return script(json(palette()).dump(), " type=\"application/json\" id=\"palette\"") +
         script(view.dump(), " type=\"application/json\" id=\"view\"") + script(graphics) +
         script(std::string(report_assets::field));
}

}  // namespace

Report make_report(const ResultsDirectory& results, const Libraries& libraries) try {
  Report report;
  const json* const view = results.document("view");
  const bool is_interactive = view != nullptr && libraries.graphics;
  std::string field;
  if (view != nullptr) {
    const FieldPictures pictures = field_pictures(*view);
    report.picture = pictures.contact ? pictures.contact : pictures.model;
    field = field_section(*view, pictures, is_interactive);
  }
  const CycleField played = cycle_field(results);
  const ReportPart part = whole_page(results, field, played.html);
  std::string scripts;
  if (const json* const mechanism = results.document("mechanism"))
    scripts += mechanism_script(*mechanism);
  if (!played.html.empty())
    scripts += script(played.data.dump(), " type=\"application/json\" id=\"cycle-data\"") +
               script(std::string(report_assets::cycle));
  if (is_interactive) scripts += field_script(*view, *libraries.graphics);
  report.html = page(page_title(results), page_head(results), part, libraries, scripts);
  return report;
} catch (const json::exception& error) {
  refuse_incomplete("the results in " + results.path.string(), error.what());
} catch (const std::out_of_range& error) {
  refuse_incomplete("the results in " + results.path.string(), error.what());
}

std::string make_comparison(const std::vector<ResultsDirectory>& all,
                            const Libraries& libraries) try {
  std::string names;
  for (const ResultsDirectory& results : all)
    names += (names.empty() ? "" : ", ") + results.about().at("name").get<std::string>();
  return page("Comparison: " + names, comparison_head(all), comparison_part(all), libraries, "");
} catch (const json::exception& error) {
  refuse_incomplete("the results in one of the directories", error.what());
} catch (const std::out_of_range& error) {
  refuse_incomplete("the results in one of the directories", error.what());
}

}  // namespace geneva::post
