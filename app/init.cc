#include "app/init.h"

#include <fmt/format.h>

#include <iostream>
#include <system_error>
#include <vector>

#include "app/commands.h"
#include "app/grammar.h"
#include "base/errors.h"
#include "base/output_file.h"
#include "model/input/case_file.h"
#include "model/input/parameter_text.h"

namespace geneva::app {

namespace {

namespace fs = std::filesystem;

void refuse_existing(const fs::path& directory, const std::vector<model::StarterFile>& files) {
  std::error_code error;
  if (fs::exists(directory, error) && !fs::is_directory(directory, error))
    throw base::InputError(
        fmt::format("{}: this is a file; name a directory for the new case", directory.string()));
  for (const model::StarterFile& file : files)
    if (fs::exists(directory / file.name, error))
      throw base::InputError(
          fmt::format("{} is there already; name another directory: geneva init DIR",
                      (directory / file.name).string()));
}

}  // namespace

int init_case(const fs::path& directory, const model::Starter& starter) {
  const std::vector<model::StarterFile> files = model::starter_case(starter);
  refuse_existing(directory, files);
  if (files.size() == 1)
    model::case_of(model::parameter_text("the new case", files[0].text), directory);
  std::error_code error;
  fs::create_directories(directory, error);
  if (error)
    throw base::InputError(
        fmt::format("{}: cannot be created: {}", directory.string(), error.message()));
  for (const model::StarterFile& file : files) {
    base::replace_file(directory / file.name, file.text);
    std::cout << shown_path(directory / file.name) << '\n';
  }
  const std::string name = directory.string();
  const bool is_plain = name.find_first_of(" \t'\"$`\\&;()<>|*?[]#~!{}") == std::string::npos;
  if (is_plain)
    std::cout << "solve it with 'geneva run" << (name == "." ? "" : " " + name) << "'\n";
  else
    std::cout << "solve it with: geneva run " << shell_quoted(name) << '\n';
  return 0;
}

}  // namespace geneva::app
