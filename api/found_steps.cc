#include "api/found_steps.h"

#include <algorithm>
#include <array>
#include <optional>

#include "api/analysis_fields.h"
#include "api/vector_of.h"
#include "post/analysis/results.h"
#include "post/analysis/surface_body.h"

namespace geneva::api {

namespace {

using post::ContactAtStep;
using post::LoadStepPoint;

template <int dim>
std::vector<ContactAtStep> contacts_of(const fem::Solution<dim>& at_step,
                                       const post::Results<dim>& results,
                                       const fem::Instant<dim>& instant) {
  std::vector<ContactAtStep> contacts;
  for (std::size_t i = 0; i < at_step.contacts.size(); ++i) {
    const fem::ContactResult<dim>& contact = at_step.contacts[i];
    const fem::PairAtInstant<dim>& pair = instant.pairs[i];
    contacts.push_back({contact.source, contact.target, vector_of(contact.force),
                        vector_of(contact.friction_force), contact.peak_pressure,
                        post::half_width(contact, results.contacts[i]), std::nullopt, pair.sticking,
                        pair.slipping, pair.dissipated});
  }
  return contacts;
}

template <int dim>
std::vector<SourceNode> source_nodes(const fem::Solution<dim>& at_step) {
  std::vector<SourceNode> nodes;
  for (const fem::ContactResult<dim>& contact : at_step.contacts) {
    const unsigned int body = post::body_of(at_step, contact.source);
    for (const fem::ContactNode<dim>& node : contact.nodes)
      nodes.push_back({vector_of(node.position), body, node.pressure});
  }
  return nodes;
}

/// @param at_step its peak pressures corrected as the last step's are
template <int dim>
FoundStep found_step(const fem::Solution<dim>& at_step, const fem::Instant<dim>& instant,
                     const Case& given, const double time) {
  const post::Results<dim> results = post::analyse(at_step);
  post::RunReport report{};
  report.allowed = given.allowed;
  FoundStep found{{time,
                   contacts_of(at_step, results, instant),
                   {},
                   instant.energy.work,
                   instant.energy.stored},
                  post::safety(at_step, results, report),
                  source_nodes(at_step),
                  fields_of(at_step, results.nodal)};
  for (std::size_t body = 0; body < at_step.problem.bodies.size(); ++body)
    found.point.stresses.push_back(
        {at_step.problem.bodies[body].name, results.max_von_mises[body].value, 0.});
  return found;
}

void compare(LoadStepPoint& now, const LoadStepPoint& before) {
  for (std::size_t i = 0; i < now.contacts.size(); ++i) {
    const double pressure = now.contacts[i].peak_pressure;
    if (const double last = before.contacts[i].peak_pressure; last > 0. && pressure > 0.)
      now.contacts[i].change = pressure / last - 1.;
  }
}

}  // namespace

template <int dim>
void StepCollector<dim>::take(const fem::Solution<dim>& on_mesh) {
  std::vector<fem::Solution<dim>> pending = std::exchange(pending_, {});
  std::vector<FoundStep> steps;
  for (std::size_t i = 0; i < pending.size(); ++i) {
    fem::Solution<dim>& at_step = pending[i];
    at_step.displacement.update_ghost_values();  // a copy has none
    at_step.edge = on_mesh.edge;
    for (fem::ContactResult<dim>& contact : at_step.contacts)
      contact.peak_pressure *= 1. + on_mesh.correction;
    steps.push_back(
        found_step(at_step, on_mesh.instants[i], given_, on_mesh.problem.steps[i].time));
    if (!steps_.empty()) compare(steps.back().point, steps_[i].point);
  }
  steps_ = std::move(steps);
}

template class StepCollector<2>;
template class StepCollector<3>;

}  // namespace geneva::api
