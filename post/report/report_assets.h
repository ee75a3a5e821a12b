#pragma once

#include <string_view>

/// The report's own style sheet and scripts, built in from the files in assets/.
namespace geneva::post::report_assets {

extern const std::string_view style;      ///< report.css
extern const std::string_view numbers;    ///< numbers.js
extern const std::string_view charts;     ///< charts.js
extern const std::string_view field;      ///< field.js
extern const std::string_view mechanism;  ///< mechanism.js
extern const std::string_view cycle;      ///< cycle.js

}  // namespace geneva::post::report_assets
