#include "fem/checkpoint.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "base/errors.h"

namespace geneva::fem {

namespace {

using nlohmann::json;

[[noreturn]] void refuse_record(const std::string& what) {
  throw base::InputError("the checkpoint is damaged: " + what);
}

const json& member(const json& given, const char* const name) {
  const auto found = given.is_object() ? given.find(name) : given.end();
  if (found == given.end()) refuse_record(fmt::format("it has no '{}'", name));
  return *found;
}

void read(const json& given, double& value) {
  if (!given.is_number() || !std::isfinite(given.get<double>())) refuse_record("a number is none");
  value = given.get<double>();
}
void read(const json& given, unsigned int& value) {
  constexpr auto most = std::numeric_limits<unsigned int>::max();
  if (!given.is_number_unsigned() || given.get<std::uint64_t>() > most)
    refuse_record("a count is none");
  value = given.get<unsigned int>();
}
void read(const json& given, bool& value) {
  if (!given.is_boolean()) refuse_record("a yes or no is neither");
  value = given.get<bool>();
}
void read(const json& given, Refined& value) {
  unsigned int number = 0;
  read(given, number);
  if (number > static_cast<unsigned int>(Refined::surroundings))
    refuse_record("a refinement is unknown");
  value = static_cast<Refined>(number);
}
template <int dim>
void read(const json& given, dealii::Point<dim>& point) {
  if (!given.is_array() || given.size() != dim) refuse_record("a place is none");
  for (unsigned int i = 0; i < dim; ++i) read(given[i], point[i]);
}
void read(const json& given, std::array<double, 3>& place) {
  if (!given.is_array() || given.size() != place.size()) refuse_record("a place is none");
  for (std::size_t i = 0; i < place.size(); ++i) read(given[i], place[i]);
}
void read(const json& given, StrengthRecord& record);
void read(const json& given, LevelRecord& record);
template <typename Value>
void read(const json& given, std::vector<Value>& values) {
  if (!given.is_array()) refuse_record("a list is none");
  for (const json& entry : given) read(entry, values.emplace_back());
}

json written(const double value) { return value; }
json written(const unsigned int value) { return value; }
json written(const bool value) { return value; }
json written(const Refined value) { return static_cast<unsigned int>(value); }
template <int dim>
json written(const dealii::Point<dim>& point) {
  json coordinates = json::array();
  for (unsigned int i = 0; i < dim; ++i) coordinates.push_back(point[i]);
  return coordinates;
}
json written(const std::array<double, 3>& place) { return place; }
json written(const StrengthRecord& record);
json written(const LevelRecord& record);
template <typename Value>
json written(const std::vector<Value>& values) {
  json list = json::array();
  for (const Value& value : values) list.push_back(written(value));
  return list;
}

template <typename Record, typename Visit>
void visit_strength(Record& record, const Visit& visit) {
  visit("von_mises", record.von_mises.value);
  visit("von_mises_place", record.von_mises.place);
  visit("von_mises_is_round", record.von_mises.is_round);
  visit("tensile", record.tensile.value);
  visit("tensile_place", record.tensile.place);
  visit("tensile_is_round", record.tensile.is_round);
}

/// Calls a function with the name and the member of everything in a record, const or not.
template <typename Record, typename Visit>
void visit_record(Record& record, const Visit& visit) {
  visit("cells", record.cells);
  visit("unknowns", record.dofs);
  visit("linear_iterations", record.linear_iterations);
  visit("peak_pressure", record.peak_pressure);
  visit("refined", record.refined);
  visit("grading", record.grading);
  visit("size_measure", record.size_measure);
  visit("energy_error", record.energy_error);
  visit("error_estimate", record.error_estimate);
  visit("mid_length_pressure", record.mid_length_pressure);
  visit("end_pressure", record.end_pressure);
  visit("strength", record.strength);
  visit("halvings", record.halvings);
  visit("active_nodes", record.active_nodes);
  visit("nodes_across", record.nodes_across);
  visit("cycled", record.cycled);
  visit("seconds", record.seconds);
  visit("one_solve_seconds", record.one_solve_seconds);
}

template <typename State, typename Visit>
void visit_state(State& state, const Visit& visit) {
  visit("refinements", state.n_refinements);
  visit("surroundings_are_fine", state.surroundings_are_fine);
  visit("open_gap", state.open_gap);
  visit("same_open_gaps", state.same_open_gaps);
  visit("unevenness_levelled", state.unevenness_levelled);
  visit("cells_beside", state.cells_beside);
}

json written(const StrengthRecord& record) {
  json result = json::object();
  visit_strength(record,
                 [&](const char* name, const auto& value) { result[name] = written(value); });
  return result;
}
void read(const json& given, StrengthRecord& record) {
  visit_strength(record, [&](const char* name, auto& value) { read(member(given, name), value); });
}

json written(const LevelRecord& record) {
  json result = json::object();
  visit_record(record, [&](const char* name, const auto& value) { result[name] = written(value); });
  return result;
}
void read(const json& given, LevelRecord& record) {
  record = {};
  visit_record(record, [&](const char* name, auto& value) { read(member(given, name), value); });
}

}  // namespace

template <int dim>
json json_of(const Checkpoint<dim>& checkpoint) {
  json refinement = json::object();
  visit_state(checkpoint.refinement,
              [&](const char* name, const auto& value) { refinement[name] = written(value); });
  return {{"source_origins", written(checkpoint.origins.source)},
          {"target_origins", written(checkpoint.origins.target)},
          {"active", written(checkpoint.active)},
          {"history", written(checkpoint.history)},
          {"refinement", refinement}};
}

template <int dim>
Checkpoint<dim> checkpoint_of(const json& given, SavedField<dim> field) {
  Checkpoint<dim> result;
  result.field = std::move(field);
  read(member(given, "source_origins"), result.origins.source);
  read(member(given, "target_origins"), result.origins.target);
  read(member(given, "active"), result.active);
  read(member(given, "history"), result.history);
  visit_state(result.refinement, [&](const char* name, auto& value) {
    read(member(member(given, "refinement"), name), value);
  });
  const std::size_t pairs = result.active.size();
  if (result.origins.source.size() != pairs || result.origins.target.size() != pairs)
    refuse_record("its contact pairs differ in number");
  if (result.history.empty() || result.history.back().cells != result.field.cells.size())
    refuse_record("its last mesh is not in its history");
  return result;
}

template json json_of(const Checkpoint<2>&);
template json json_of(const Checkpoint<3>&);
template Checkpoint<2> checkpoint_of(const json&, SavedField<2>);
template Checkpoint<3> checkpoint_of(const json&, SavedField<3>);

}  // namespace geneva::fem
