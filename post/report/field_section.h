#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace geneva::post {

/// The place on the page where the field view appears, with its controls, and the picture that
/// stands in for it on paper.
/// @param view what view.json holds
/// @param picture SVG
/// @param is_interactive whether the view's scripts are on the page; else there is the picture only
std::string field_section(const nlohmann::json& view, const std::string& picture,
                          bool is_interactive);

}  // namespace geneva::post
