#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/report/html/library.h"
#include "post/report/results/results_directory.h"

namespace geneva::post {

/// What is made for looking at.
struct Report {
  std::string html;                    ///< one page that needs nothing besides itself
  std::optional<std::string> picture;  ///< of the stress around the contact, as SVG; none without
};

/// The report on a results directory.
/// @throws base::InputError if a document lacks what its format promises
Report make_report(const ResultsDirectory& results, const Libraries& libraries);

/// A page that shows runs side by side, in the units of the first.
/// @param all two or more
/// @throws base::InputError if one of them holds no run, or lacks what its format promises
std::string make_comparison(const std::vector<ResultsDirectory>& all, const Libraries& libraries);

}  // namespace geneva::post
