#include "post/report/html/html.h"

#include <fmt/format.h>

namespace geneva::post {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char character : text) switch (character) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += character;
    }
  return result;
}

namespace {

/// On narrow screens a cell lays its parts out side by side: marked-up text is to stay one part.
std::string in_one_part(const std::string& cell) {
  return cell.find('<') == std::string::npos ? cell : "<span>" + cell + "</span>";
}

}  // namespace

std::string HtmlTable::html() const {
  std::string text = fmt::format(
      "<div class=\"scroll\" tabindex=\"0\">\n<table{}>\n<caption>{}</caption>\n<thead><tr>",
      kind.empty() ? "" : fmt::format(" class=\"{}\"", kind), caption);
  for (const std::string& heading : headings)
    text += fmt::format("<th scope=\"col\">{}</th>", heading);
  text += "</tr></thead>\n<tbody>\n";
  for (const std::vector<std::string>& row : rows) {
    text += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i)
      text += i == 0 ? fmt::format("<th scope=\"row\">{}</th>", row[i])
                     : fmt::format("<td data-label=\"{}\">{}</td>",
                                   i < headings.size() ? headings[i] : "", in_one_part(row[i]));
    text += "</tr>\n";
  }
  return text + "</tbody>\n</table>\n</div>\n";
}

std::string html_section(const std::string& id, const std::string& heading,
                         const std::string& content) {
  return fmt::format(
      "<section id=\"{0}\" aria-labelledby=\"{0}-heading\">\n"
      "<h2 id=\"{0}-heading\">{1}</h2>\n{2}</section>\n",
      id, heading, content);
}

}  // namespace geneva::post
