#include "post/report/results/case_inputs.h"

#include <sstream>

namespace geneva::post {

namespace {

constexpr const char* mark = "# default:";  ///< behind what the case gives

std::string without_spaces(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(' ');
  return begin == std::string::npos ? ""
                                    : text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

}  // namespace

std::vector<CaseInput> case_inputs(const std::string& case_text) {
  std::vector<CaseInput> inputs;
  std::vector<std::string> path;
  std::istringstream lines(case_text);
  for (std::string line; std::getline(lines, line);) {
    const std::string text = without_spaces(line);
    if (text.rfind("subsection ", 0) == 0) path.push_back(text.substr(11));
    if (text == "end" && !path.empty()) path.pop_back();
    const std::size_t sign = text.find('=');
    if (text.rfind("set ", 0) != 0 || sign == std::string::npos) continue;
    const std::size_t comment = text.find(mark);
    std::string name;
    for (std::size_t i = 1; i < path.size(); ++i) name += path[i] + "/";
    inputs.push_back({name + without_spaces(text.substr(4, sign - 4)),
                      without_spaces(text.substr(
                          sign + 1, comment == std::string::npos ? comment : comment - sign - 1)),
                      comment != std::string::npos, !path.empty() && path.front() == "Published"});
  }
  return inputs;
}

std::string given_lines(const std::string& case_text) {
  std::string given;
  std::vector<std::string> opened;  // subsections of which nothing is given so far
  std::size_t depth = 0;            // of those that are in the text
  std::istringstream lines(case_text);
  for (std::string line; std::getline(lines, line);) {
    const std::string text = without_spaces(line);
    if (text.rfind("subsection ", 0) == 0) opened.push_back(text);
    if (text == "end") {
      if (!opened.empty())
        opened.pop_back();
      else if (depth > 0)
        given += std::string(2 * --depth, ' ') + "end\n";
    }
    const std::size_t comment = text.find(mark);
    if (text.rfind("set ", 0) != 0 || comment == std::string::npos) continue;
    for (const std::string& section : opened)
      given += std::string(2 * depth++, ' ') + section + '\n';
    opened.clear();
    given += std::string(2 * depth, ' ') + without_spaces(text.substr(0, comment)) + '\n';
  }
  return given;
}

}  // namespace geneva::post
