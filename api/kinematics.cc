#include "api/kinematics.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "api/engagement.h"
#include "api/limits.h"
#include "api/mechanism_picture.h"
#include "api/output_directory.h"
#include "api/roller_choice.h"
#include "api/version.h"
#include "base/errors.h"
#include "model/case_header.h"
#include "model/mechanism_state.h"
#include "model/naming.h"

namespace geneva {

namespace {

post::KinematicsReport kinematics_report(const Case& given, const int steps) {
  if (!given.mechanism)
    model::refuse_model(given, "there is no Geneva mechanism", "geneva kinematics", "mechanism");
  const model::MechanismCase& mechanism = *given.mechanism;
  const model::MechanismDynamics dynamics = model::mechanism_dynamics(mechanism);
  const loads::PinContact contact = api::pin_contact(mechanism, dynamics.sizes);
  const loads::Characteristics values =
      loads::characteristics(dynamics.driven, dynamics.train, contact);
  return {model::header_of(given),
          version,
          dynamics.driven.mechanism().name,
          dynamics.train.roller.has_value(),
          dynamics.driven.drive().reference_speed,
          values,
          dynamics.driven.unbounded(),
          loads::kinematics_rows(dynamics.driven, dynamics.train, contact, steps),
          api::roller_choice(mechanism, values),
          api::motion_limits(given, contact, values, api::limited_pressure(mechanism, values))};
}

/// The table's pressure is that of an even load.
std::vector<std::string> notices_in_space(const model::MechanismCase& mechanism,
                                          const post::KinematicsReport& report) {
  if (!mechanism.space) return {};
  const bool is_judged =
      std::any_of(report.limits.begin(), report.limits.end(), [](const post::LimitRow& row) {
        return row.quantity == "peak contact pressure" || row.quantity.rfind("contact, ", 0) == 0;
      });
  return {
      is_judged
          ? "the pressures of the table are those of an even load along the pin; limits of the "
            "contact are judged by that of line contacts along it ('geneva estimate')"
          : "the pressures of the table are those of an even load along the pin, which bending, "
            "tilt and edges exceed: no limit of the contact is judged by them; 'geneva run' and "
            "'geneva cycle' know more"};
}

}  // namespace

Kinematics kinematics(const Case& given, const int steps) {
  return model::naming(given, [&] {
    post::KinematicsReport report = kinematics_report(given, steps);
    std::vector<std::string> notices = given.notices;
    for (const std::string& notice : model::notices_of(*given.mechanism, given.units))
      notices.push_back(notice);
    for (const std::string& notice : notices_in_space(*given.mechanism, report))
      notices.push_back(notice);
    if (const std::string unjudged = api::unjudged_yield(given); !unjudged.empty())
      notices.push_back("not judged: " + unjudged);
    return Kinematics{given, std::move(report), std::move(notices)};
  });
}

std::string table(const Kinematics& kinematics) {
  return post::kinematics_table(kinematics.report, kinematics.given.units);
}

Written write(const Kinematics& kinematics, const std::filesystem::path& directory) {
  const auto& [given, report, notices] = kinematics;
  return api::write_results(directory, given, "kinematics",
                            {{"kinematics.json", post::kinematics_summary(report).dump(2) + "\n"},
                             {"kinematics.csv", post::kinematics_csv(report, given.units)},
                             {"mechanism.json", api::mechanism_text(*given.mechanism)}});
}

}  // namespace geneva
