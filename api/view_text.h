#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/units.h"
#include "post/output/cycle_fields.h"
#include "post/view/cycle_view.h"

namespace geneva::api {

/// What the report plays of instants in the plane.
inline std::string view_text(const std::vector<post::CycleFields>& instants,
                             const base::UnitSystem units) {
  std::vector<post::InstantField> fields;
  for (const post::CycleFields& instant : instants)
    fields.push_back({instant.fields.places, instant.fields.von_mises, instant.fields.cells});
  return post::cycle_view(fields, units).dump() + "\n";
}

}  // namespace geneva::api
