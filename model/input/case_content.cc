#include "model/input/case_content.h"

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <sstream>

#include "base/checksum.h"
#include "base/input_file.h"

namespace geneva::model {

std::string content_of(const std::string& completed, const std::string& model,
                       const std::vector<std::filesystem::path>& inputs) {
  std::string decisive = model + '\n';
  std::istringstream lines(completed);
  std::string section;  // the outermost one
  int depth = 0;
  for (std::string line; std::getline(lines, line);) {
    line = boost::algorithm::trim_copy(line.substr(0, line.find('#')));
    if (line.rfind("subsection ", 0) == 0 && depth++ == 0) section = line.substr(11);
    const bool is_models = depth > 0 && boost::algorithm::to_lower_copy(section) == model;
    if (!line.empty() && is_models) decisive += line + '\n';
    if (line == "end") --depth;
  }
  for (const std::filesystem::path& file : inputs) decisive += base::bytes_of(file);
  return base::checksum(decisive);
}

}  // namespace geneva::model
