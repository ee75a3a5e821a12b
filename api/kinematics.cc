#include "api/kinematics.h"

#include <nlohmann/json.hpp>

#include "api/limits.h"
#include "api/mechanism_picture.h"
#include "api/output_directory.h"
#include "api/roller_choice.h"
#include "api/version.h"
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
          api::motion_limits(given, contact, values)};
}

}  // namespace

Kinematics kinematics(const Case& given, const int steps) {
  return model::naming(given, [&] {
    post::KinematicsReport report = kinematics_report(given, steps);
    return Kinematics{given, std::move(report), model::notices_of(*given.mechanism, given.units)};
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
