#include "post/report/html/library.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace geneva::post {

namespace fs = std::filesystem;

namespace {

std::optional<std::string> library_text(const fs::path& file) {
  std::ifstream stream(file);
  if (!stream) return std::nullopt;
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace

Libraries installed_libraries() {
  const char* const given = std::getenv("GENEVA_JAVASCRIPT");
  const fs::path directory = given == nullptr ? "/usr/share/javascript" : given;
  Libraries libraries;
  libraries.charts = library_text(directory / "chart.js" / "chart.min.js");
  if (!libraries.charts) libraries.missing.emplace_back("libjs-chart.js");
  const auto core = library_text(directory / "three" / "three.min.js");
  const auto controls =
      library_text(directory / "three" / "examples" / "js" / "controls" / "OrbitControls.js");
  if (core && controls)
    libraries.graphics = *core + "\n" + *controls;
  else
    libraries.missing.emplace_back("libjs-three");
  return libraries;
}

}  // namespace geneva::post
