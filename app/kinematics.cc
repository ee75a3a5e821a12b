#include "app/kinematics.h"

#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/mechanism_picture.h"
#include "app/output_directory.h"
#include "app/report.h"
#include "app/version.h"
#include "model/mechanism_state.h"
#include "model/naming.h"

namespace geneva::app {

post::KinematicsReport make_kinematics(const model::Case& given, const int steps) {
  if (!given.mechanism)
    model::refuse_model(given, "there is no Geneva mechanism", "geneva kinematics", "mechanism");
  const model::MechanismCase& mechanism = *given.mechanism;
  const model::MechanismDynamics dynamics = model::mechanism_dynamics(mechanism);
  const loads::PinContact contact = pin_contact(mechanism, dynamics.sizes);
  return {model::header_of(given),
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
  const model::Case given = model::read_case(case_directory);
  const post::KinematicsReport report =
      model::naming(given, [&] { return make_kinematics(given, steps); });
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
