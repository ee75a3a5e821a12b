#include "app/kinematics.h"

#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/mechanism_picture.h"
#include "app/mechanism_state.h"
#include "app/naming.h"
#include "app/output_directory.h"
#include "app/report.h"
#include "app/version.h"

namespace geneva::app {

post::KinematicsReport make_kinematics(const Case& given, const int steps) {
  if (!given.mechanism)
    refuse_model(given, "there is no Geneva mechanism", "geneva kinematics", "mechanism");
  const MechanismCase& mechanism = *given.mechanism;
  const MechanismDynamics dynamics = mechanism_dynamics(mechanism);
  const loads::PinContact contact = pin_contact(mechanism, dynamics.sizes);
  return {header_of(given),
          version,
          dynamics.driven.mechanism().name,
          dynamics.train.roller.has_value(),
          dynamics.driven.drive().reference_speed,
          loads::characteristics(dynamics.driven, dynamics.train, contact),
          dynamics.driven.unbounded(),
          loads::kinematics_rows(dynamics.driven, dynamics.train, contact, steps)};
}

int kinematics_of_case(const std::filesystem::path& case_directory,
                       const std::filesystem::path& output, const int steps) {
  const Case given = read_case(case_directory);
  const post::KinematicsReport report =
      naming(given, [&] { return make_kinematics(given, steps); });
  std::cout << name_of(given) << (given.title.empty() ? "" : ": " + given.title) << '\n'
            << post::kinematics_table(report, given.units);
  for (const std::string& notice : notices_of(*given.mechanism, given.units))
    std::cout << "note: " << notice << '\n';
  const std::filesystem::path target = output.empty() ? given.directory / "results" : output;
  const auto removed =
      write_results(target, given, "kinematics",
                    {{"kinematics.json", post::kinematics_summary(report).dump(2) + "\n"},
                     {"kinematics.csv", post::kinematics_csv(report, given.units)},
                     {"mechanism.json", mechanism_text(*given.mechanism)}},
                    write_report);
  if (!removed.empty()) std::cout << removal_notice(removed) << '\n';
  std::cout << "kinematics.json, kinematics.csv and report.html in " << shown_path(target) << '\n';
  return 0;
}

}  // namespace geneva::app
