#include "api/checkpoint_file.h"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/trim.hpp>
#include <cmath>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string_view>
#include <type_traits>
#include <utility>

#include "api/version.h"
#include "base/checksum.h"
#include "base/directory_replacement.h"
#include "base/errors.h"
#include "base/input_file.h"
#include "fem/discretisation/gather.h"
#include "model/input/parameters.h"
#include "model/together.h"

namespace geneva::api {

namespace fs = std::filesystem;

namespace {

using nlohmann::json;

constexpr std::string_view mark = "geneva checkpoint ";

[[noreturn]] void refuse_damaged(const std::string& what) {
  throw base::InputError("the checkpoint is damaged: " + what);
}

/// The bytes of numbers, as this machine keeps them.
template <typename Number>
void append(std::string& text, const std::vector<Number>& numbers) {
  static_assert(std::is_trivially_copyable_v<Number>);
  text.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
}

/// Takes them from the front of a text.
template <typename Number>
void take(std::string_view& text, const json& sizes, const char* const name,
          std::vector<Number>& numbers) {
  const json size = sizes.is_object() ? sizes.value(name, json()) : json();
  if (!size.is_number_unsigned() || size.get<std::size_t>() > text.size() / sizeof(Number))
    refuse_damaged(fmt::format("its {} are not all there", name));
  numbers.resize(size.get<std::size_t>());
  std::memcpy(numbers.data(), text.data(), numbers.size() * sizeof(Number));
  text.remove_prefix(numbers.size() * sizeof(Number));
}

template <int dim>
std::string checksum_of(const mesh::MeshData<dim>& mesh) {
  std::string bytes;
  append(bytes, mesh.vertices);
  for (const mesh::Cell<dim>& cell : mesh.cells) {
    append(bytes, std::vector{cell.vertices});
    append(bytes, std::vector{cell.body});
  }
  for (const mesh::Face<dim>& face : mesh.faces) {
    append(bytes, std::vector{face.vertices});
    append(bytes, std::vector{face.surface});
    append(bytes, std::vector{face.circle});
  }
  return base::checksum(bytes);
}

/// The parameters that decide on the solution, "Section / Name", and their values.
std::map<std::string, std::string> decisive_parameters(const std::string& completed) {
  std::set<std::string> others{"Title", "Project", "Author", "Output units"};
  for (const model::Parameter& parameter : model::settings_parameters())
    if (parameter.name != "Dimension") others.insert(parameter.name);
  const std::set<std::string> other_sections{model::names::published, model::names::allowable};
  std::map<std::string, std::string> result;
  std::vector<std::string> sections;
  std::istringstream lines(completed);
  for (std::string line; std::getline(lines, line);) {
    line = boost::algorithm::trim_copy(line.substr(0, line.find('#')));
    const std::size_t equals = line.find('=');
    if (line.rfind("subsection ", 0) == 0) sections.push_back(line.substr(11));
    if (line == "end" && !sections.empty()) sections.pop_back();
    if (line.rfind("set ", 0) != 0 || equals == std::string::npos) continue;
    const std::string name = boost::algorithm::trim_copy(line.substr(4, equals - 4));
    const bool decides =
        sections.empty() ? others.count(name) == 0 : other_sections.count(sections.front()) == 0;
    const std::string path =
        sections.empty() ? "" : fmt::format("{} / ", fmt::join(sections, " / "));
    if (decides) result[path + name] = boost::algorithm::trim_copy(line.substr(equals + 1));
  }
  return result;
}

/// As JSON, which is UTF-8, gives it back.
std::string as_json_has_it(const std::string& text) {
  return json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace))
      .get<std::string>();
}

/// Of the files that the case reads beside case.prm, by name.
std::map<std::string, std::string> checksums_of_files(const model::Case& given) {
  std::map<std::string, std::string> result;
  for (std::size_t i = 1; i < given.inputs.size(); ++i)
    result[given.inputs[i].filename().string()] = base::checksum(base::bytes_of(given.inputs[i]));
  return result;
}

json written(const post::Figures& figures) {
  json result = json::array();
  for (const auto& [figure, value] : figures)
    result.push_back({static_cast<int>(figure), std::isfinite(value) ? json(value) : json()});
  return result;
}

post::Figures read_figures(const json& given) {
  post::Figures figures;
  for (const json& pair : given) {
    const int figure = pair.at(0).get<int>();
    if (figure < 0 || figure > static_cast<int>(post::Figure::section_moment))
      refuse_damaged("a figure is unknown");
    figures[static_cast<post::Figure>(figure)] =
        pair.at(1).is_null() ? std::nan("") : pair.at(1).get<double>();
  }
  return figures;
}

json written(const std::vector<post::RunFigures>& meshes) {
  json result = json::array();
  for (const post::RunFigures& mesh : meshes) {
    json contacts = json::array();
    for (const post::Figures& contact : mesh.contacts) contacts.push_back(written(contact));
    result.push_back({{"contacts", contacts}, {"mechanism", written(mesh.mechanism)}});
  }
  return result;
}

std::vector<post::RunFigures> read_meshes(const json& given) {
  std::vector<post::RunFigures> meshes;
  for (const json& mesh : given) {
    post::RunFigures figures;
    for (const json& contact : mesh.at("contacts"))
      figures.contacts.push_back(read_figures(contact));
    figures.mechanism = read_figures(mesh.at("mechanism"));
    meshes.push_back(figures);
  }
  return meshes;
}

/// The line of JSON, and the numbers behind it.
struct Parts {
  json header = json::object();
  std::string_view numbers;
};

Parts parts_of(const std::string_view text) {
  const std::size_t first = text.find('\n');
  if (text.rfind(mark, 0) != 0 || first == std::string_view::npos)
    refuse_damaged("it does not begin as one");
  const std::string_view content = text.substr(first + 1);
  if (text.substr(mark.size(), first - mark.size()) != base::checksum(content))
    refuse_damaged("its checksum is another");
  const std::size_t second = content.find('\n');
  const json header = json::parse(content.substr(0, second), nullptr, false);
  if (second == std::string_view::npos || !header.is_object())
    refuse_damaged("its description cannot be read");
  return {header, content.substr(second + 1)};
}

/// What is different between two lists of parameters; empty if nothing is.
std::string difference(const std::map<std::string, std::string>& before,
                       const std::map<std::string, std::string>& now) {
  const auto quoted = [](const auto& list, const std::string& name) {
    const auto found = list.find(name);
    return found == list.end() ? std::string("missing") : fmt::format("'{}'", found->second);
  };
  std::map<std::string, std::string> all = before;
  all.insert(now.begin(), now.end());
  for (const auto& [name, unused] : all)
    if (quoted(before, name) != quoted(now, name))
      return fmt::format("'{}' was {} and is {}", name, quoted(before, name), quoted(now, name));
  return "";
}

void check_same_case(const json& header, const model::Case& given) {
  const auto refuse = [](const std::string& what) {
    throw base::InputError(fmt::format(
        "the checkpoint cannot be continued: {}; run the case without --continue", what));
  };
  if (header.value("geneva", json()) != json(version))
    refuse(fmt::format("it is of another version of geneva than {}", version));
  const json before = header.value("case", json());
  const json files = header.value("files", json());
  if (!before.is_string() || !files.is_object()) refuse_damaged("it does not tell its case");
  if (const std::string what = difference(decisive_parameters(before.get<std::string>()),
                                          decisive_parameters(as_json_has_it(given.completed)));
      !what.empty())
    refuse("the case has changed: " + what);
  for (const auto& [name, checksum] : checksums_of_files(given))
    if (files.value(name, json()) != json(checksum))
      refuse(fmt::format("the file {} has changed", name));
}

/// The file to continue from.
fs::path checkpoint_of(const fs::path& results) {
  const fs::path unfinished = unfinished_checkpoint(results);
  std::error_code ignored;
  for (const fs::path& file : {unfinished, results / "checkpoint.bin"})
    if (fs::is_regular_file(file, ignored)) return file;
  throw base::InputError(fmt::format(
      "there is no checkpoint to continue from, neither {} nor {}; run the case without --continue "
      "(with 'Checkpoint' = true every mesh leaves one)",
      unfinished.string(), (results / "checkpoint.bin").string()));
}

}  // namespace

fs::path unfinished_checkpoint(const fs::path& results) {
  return base::beside(base::resolved(results), "checkpoint");
}

template <int dim>
std::string checkpoint_text(const model::Case& given, const mesh::MeshData<dim>& mesh,
                            const SavedRun<dim>& run) {
  const fem::SavedField<dim>& field = run.state.field;
  const json header{{"geneva", version},
                    {"case", given.completed},
                    {"files", checksums_of_files(given)},
                    {"mesh", checksum_of(mesh)},
                    {"state", fem::json_of(run.state)},
                    {"figures", written(run.figures)},
                    {"sizes",
                     {{"cells", field.cells.size()},
                      {"nodes", field.nodes.size()},
                      {"displacement", field.displacement.size()}}}};
  std::string content = header.dump(-1, ' ', false, json::error_handler_t::replace) + '\n';
  append(content, field.cells);
  append(content, field.nodes);
  append(content, field.displacement);
  return fmt::format("{}{}\n", mark, base::checksum(content)) + content;
}

std::string read_checkpoint(const MPI_Comm communicator, const fs::path& results,
                            const model::Case& given) {
  std::string text;
  model::together(communicator, [&] {
    if (dealii::Utilities::MPI::this_mpi_process(communicator) != 0) return;
    const fs::path file = checkpoint_of(results);
    text = base::bytes_of(file);
    try {
      check_same_case(parts_of(text).header, given);
    } catch (const base::InputError& error) {
      throw base::InputError(fmt::format("{}: {}", file.string(), error.what()));
    }
  });
  return fem::text_of(communicator, 0, std::move(text));
}

template <int dim>
SavedRun<dim> saved_run(const std::string& text, const mesh::MeshData<dim>& mesh) {
  auto [header, numbers] = parts_of(text);
  if (header.value("mesh", json()) != json(checksum_of(mesh)))
    throw base::InputError(
        "the checkpoint cannot be continued: the coarse mesh has changed (another version of "
        "Gmsh?); run the case without --continue");
  const json sizes = header.value("sizes", json());
  fem::SavedField<dim> field;
  take(numbers, sizes, "cells", field.cells);
  take(numbers, sizes, "nodes", field.nodes);
  take(numbers, sizes, "displacement", field.displacement);
  fem::check(field);
  SavedRun<dim> run{fem::checkpoint_of(header.value("state", json()), std::move(field)), {}};
  try {
    run.figures = read_meshes(header.at("figures"));
  } catch (const json::exception&) {
    refuse_damaged("its figures are none");
  }
  const bool has_all_contacts =
      std::all_of(run.figures.begin(), run.figures.end(), [&](const post::RunFigures& on_mesh) {
        return on_mesh.contacts.size() == run.state.active.size();
      });
  if (run.figures.size() != run.state.history.size() || !has_all_contacts)
    refuse_damaged("it has not the figures of every mesh");
  return run;
}

template std::string checkpoint_text(const model::Case&, const mesh::MeshData<2>&,
                                     const SavedRun<2>&);
template std::string checkpoint_text(const model::Case&, const mesh::MeshData<3>&,
                                     const SavedRun<3>&);
template SavedRun<2> saved_run(const std::string&, const mesh::MeshData<2>&);
template SavedRun<3> saved_run(const std::string&, const mesh::MeshData<3>&);

}  // namespace geneva::api
