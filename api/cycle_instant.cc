#include "api/cycle_instant.h"

#include <deal.II/base/timer.h>

#include <algorithm>
#include <array>
#include <utility>

#include "api/analysis_fields.h"
#include "api/analysis_notices.h"
#include "api/mechanism_results.h"
#include "fem/contact_problem.h"
#include "model/contact_geometry.h"
#include "model/model.h"
#include "model/naming.h"
#include "post/analysis/hertz_objection.h"
#include "post/analysis/results.h"
#include "post/analysis/strength_rows.h"

namespace geneva::api {

namespace {

/// The case at an instant, with the wall that carries then as the driving one.
Case case_at(const Case& given, const loads::PinLoad& load) {
  Case result = given;
  result.mechanism->angle_kind = model::MechanismCase::AngleKind::given;
  result.mechanism->driver_angle = load.driver_angle;
  result.mechanism->is_mirrored = load.wall == loads::Wall::braking;
  return result;
}

/// @param is_mirrored whether the solution is the mirror image about y = 0
template <int dim>
std::vector<post::CycleStress> stresses_of(const fem::Solution<dim>& solution,
                                           const bool is_mirrored) {
  std::vector<post::CycleStress> stresses;
  for (const post::NamedStress<dim>& stress : post::named_stresses(solution)) {
    if (!stress.is_bounded) continue;
    std::array<double, 3> place{};
    std::copy(stress.maximum.place.begin(), stress.maximum.place.end(), place.begin());
    if (is_mirrored) place[1] = -place[1];
    const auto body = std::find_if(solution.problem.bodies.begin(), solution.problem.bodies.end(),
                                   [&](const auto& one) { return one.name == stress.body; });
    stresses.push_back({stress.body, stress.name, stress.maximum.value,
                        stress.maximum.total_error(), stress.where, place,
                        static_cast<unsigned int>(body - solution.problem.bodies.begin())});
  }
  return stresses;
}

double half_width_of(const fem::Solution<2>& solution) {
  return solution.contacts.front().half_width;
}
double half_width_of(const fem::Solution<3>& solution) {
  return post::analyse(solution).contacts.front().half_width;
}

/// An instant solved.
struct SolvedInstant {
  post::CycleContact contact;
  post::NodalFields fields;
};

template <int dim>
SolvedInstant solved(const Case& at, const MPI_Comm communicator, mesh::Mesher* const mesher) {
  const model::Model<dim> model = model::make_model<dim>(communicator, at, mesher);
  const fem::Solution<dim> solution =
      fem::solve_contact(communicator, model.mesh, model.problem, at.settings, {}, {});
  const double sign = at.mechanism->is_mirrored ? -1. : 1.;
  post::CycleContact contact{};
  contact.peak_pressure = solution.contacts.front().peak_pressure;
  contact.error = solution.error_estimate;
  contact.half_width = half_width_of(solution);
  if (const auto torque = bore_torque(model, *at.mechanism, solution))
    contact.bore_torque = sign * *torque;
  contact.expected_bore_torque = sign * model.mechanism->expected_bore_torque;
  contact.stresses = stresses_of(solution, at.mechanism->is_mirrored);
  contact.hertz_objection =
      post::hertz_objection(solution, solution.contacts.front(), contact.half_width);
  contact.shortfall = shortfall(solution, at.settings.accuracy);
  post::NodalFields fields = rounded_fields_of(solution, post::nodal_stress(solution));
  return {std::move(contact),
          at.mechanism->is_mirrored ? post::mirrored(std::move(fields)) : std::move(fields)};
}

}  // namespace

bool touches_wall(const Case& given, const loads::PinLoad& load) {
  try {
    const Case at = case_at(given, load);
    model::contact_geometry(*at.mechanism, model::mechanism_state(*at.mechanism));
    return true;
  } catch (const InputError&) {
    return false;
  }
}

post::NodalFields solve_instant(post::CyclePoint& point, const Case& given,
                                const MPI_Comm communicator, mesh::Mesher* const mesher) {
  const dealii::Timer timer;
  try {
    const Case at = case_at(given, point.instant.load);
    SolvedInstant found = model::naming(at, [&] {
      return at.dimension == 3 ? solved<3>(at, communicator, mesher)
                               : solved<2>(at, communicator, mesher);
    });
    point.contact = std::move(found.contact);
    point.contact->seconds = timer.wall_time();
    return std::move(found.fields);
  } catch (const InputError& error) {
    point.refusal = error.what();
  } catch (const LimitReached& error) {
    point.refusal = error.what();
  }
  return {};
}

}  // namespace geneva::api
