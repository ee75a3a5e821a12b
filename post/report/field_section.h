#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace geneva::post {

/// The place on the page where the field view appears, with its controls.
/// @param view what view.json holds
std::string field_section(const nlohmann::json& view);

}  // namespace geneva::post
