#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "post/report/pictures/field_picture.h"

namespace geneva::post {

/// SVG documents.
struct FieldPictures {
  std::optional<std::string> contact;  ///< around it; none without contact
  std::optional<std::string> model;    ///< all of it, in 3-D without contact a cut
};

/// What stands for a run beside others: the contact, if there is one.
/// @param view what view.json holds
PicturePart main_part(const nlohmann::json& view);

/// Those that a view allows.
/// @param view what view.json holds
/// @throws base::InputError if it is damaged
FieldPictures field_pictures(const nlohmann::json& view);

/// The place on the page where the field view appears, with its controls, the pictures that stand
/// in for it on paper, and what the places of the maximum stresses are.
/// @param view what view.json holds
/// @param is_interactive whether the view's scripts are on the page; else there are the pictures
/// only
std::string field_section(const nlohmann::json& view, const FieldPictures& pictures,
                          bool is_interactive);

}  // namespace geneva::post
