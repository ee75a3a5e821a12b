#include "fem/refinement_pass.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/errors.h"
#include "fem/adaptivity/error_estimate.h"

namespace geneva::fem {

namespace {

using History = std::vector<LevelRecord>;

/// Zones are made more even as long as that lowers their unevenness by this factor.
constexpr double minimum_gain = 0.9;

/// How many times as many cells the next mesh will have. The grading of the mesh makes some beyond
/// the flagged ones' children.
template <int dim>
double growth_by(const double flagged, const History& history) {
  constexpr double grading_overhead = 1.3;
  return 1. + grading_overhead * ((1 << dim) - 1) * flagged / history.back().cells;
}

bool is_resolved(const History& history) {
  return !history.empty() && history.back().nodes_across >= nodes_for_grading;
}

/// Whether a contact that was a point on the mesh before has nodes enough now, while the cells
/// around are still those of a point: with a finer zone they would both change at once, and the
/// pressure by more than the zone's fineness explains.
template <int dim>
bool has_skipped_grading(const History& history) {
  return dim == 2 && history.size() > 1 &&
         history[history.size() - 2].nodes_across < nodes_for_grading &&
         history.back().nodes_across >= 2 * fewest_active_nodes;
}

/// Whether the next mesh, too, would have too few nodes in contact; in the plane, where meshes are
/// cheap, whether this one has.
template <int dim>
bool next_pressure_is_of_no_use(const History& history) {
  const unsigned int across = history.back().nodes_across;
  const unsigned int expected = dim == 2 || across == 0 ? across : 2 * across - 1;
  return expected < fewest_active_nodes;
}

template <int dim>
double unevenness_of(const Level<dim>& level) {
  if constexpr (dim == 2) return unevenness(level.interfaces);
  return 1.;
}

/// The contact pair with the minimum gap, and that gap.
std::pair<std::size_t, double> nearest_pair(const std::vector<ContactState>& contacts) {
  std::pair<std::size_t, double> nearest{0, std::numeric_limits<double>::max()};
  for (std::size_t i = 0; i < contacts.size(); ++i)
    for (const double gap : contacts[i].gap)
      if (gap < nearest.second) nearest = {i, gap};
  return nearest;
}

template <int dim>
SurfaceIds ids_of_pairs(const mesh::MeshData<dim>& mesh, const Problem<dim>& problem) {
  SurfaceIds ids;
  for (const ContactPair& pair : problem.pairs)
    ids.emplace_back(mesh::index_of(mesh.surfaces, pair.source),
                     mesh::index_of(mesh.surfaces, pair.target));
  return ids;
}

}  // namespace

template <int dim>
RefinementPass<dim>::RefinementPass(const mesh::MeshData<dim>& mesh, const Problem<dim>& problem,
                                    const Settings& settings)
    : problem_(problem),
      settings_(settings),
      surface_ids_(ids_of_pairs(mesh, problem)),
      grading_(first_grading<dim>(settings.accuracy)) {}

template <int dim>
void RefinementPass<dim>::restore(const Checkpoint<dim>& start) {
  state_ = start.refinement;
  grading_ = start.history.back().grading;
  refined_ = start.history.back().refined;
}

template <int dim>
void RefinementPass<dim>::record(LevelRecord& record) const {
  record.refined = refined_;
  record.halvings = last_halvings_;
  record.grading = grading_;
}

template <int dim>
double RefinementPass<dim>::flag(const Equilibrium<dim>& equilibrium, const Vector& displacement,
                                 const History& history) const {
  return flag_cells(
      *equilibrium.mesh().dof_handler, displacement, equilibrium.level().interfaces, surface_ids_,
      {refined_ == Refined::zone, is_resolved(history) ? std::optional(grading_) : std::nullopt,
       size_growth(problem_), refined_ != Refined::nothing});
}

template <int dim>
std::optional<double> RefinementPass<dim>::choose(const Equilibrium<dim>& equilibrium,
                                                  const LevelState& found, const History& history,
                                                  const PressureError& error) {
  constexpr double share_of_zone = 0.6;
  if (has_spread(equilibrium.level())) return level_off(equilibrium, history);
  if (has_skipped_grading<dim>(history)) {
    refined_ = Refined::nothing;
    const double flagged = flag(equilibrium, found.displacement, history);
    if (flagged > 0.) return growth_by<dim>(flagged, history);
  }
  const bool zone_is_fine = error.zone <= share_of_zone * settings_.accuracy;
  double flagged = 0.;
  if (error.surroundings > 0. &&
      (zone_is_fine || surroundings_come_first(equilibrium, found, history, error))) {
    refined_ = Refined::surroundings;
    grading_ *= grading_step<dim>;
    flagged = flag(equilibrium, found.displacement, history);
    if (flagged == 0. && zone_is_fine) {
      state_.surroundings_are_fine = true;
      return std::nullopt;
    }
  }
  if (flagged == 0.) {
    refined_ = Refined::zone;
    flagged = flag(equilibrium, found.displacement, history);
  }
  return growth_by<dim>(flagged, history);
}

template <int dim>
double RefinementPass<dim>::choose_flagged(const unsigned int flagged, const History& history) {
  refined_ = Refined::nothing;
  return growth_by<dim>(flagged, history);
}

template <int dim>
double RefinementPass<dim>::growth_by_flagged(const unsigned int flagged, const History& history) {
  return growth_by<dim>(flagged, history) - 1.;
}

template <int dim>
bool RefinementPass<dim>::has_spread(const Level<dim>& level) const {
  constexpr double maximum_ratio = 4.;
  const double now = unevenness_of(level);
  return now > maximum_ratio && now < minimum_gain * state_.unevenness_levelled;
}

/// Flags the longest edges of the zones only; how wide they must be is known after the next solve.
template <int dim>
double RefinementPass<dim>::level_off(const Equilibrium<dim>& equilibrium, const History& history) {
  refined_ = Refined::nothing;
  state_.unevenness_levelled = unevenness_of(equilibrium.level());
  return growth_by<dim>(
      flag_zone_part(*equilibrium.mesh().dof_handler, equilibrium.level().interfaces, surface_ids_,
                     ZonePart::longest),
      history);
}

/// Whether the part of the surroundings is still to be measured, on a mesh where the pressure is of
/// use or because a finer zone is dear beside the cells that are there for the contact.
template <int dim>
bool RefinementPass<dim>::surroundings_come_first(const Equilibrium<dim>& equilibrium,
                                                  const LevelState& found, const History& history,
                                                  const PressureError& error) {
  constexpr double dear = 4.;
  const bool is_measured =
      std::any_of(history.begin(), history.end(),
                  [](const LevelRecord& level) { return level.refined == Refined::surroundings; });
  if (dim == 2 || is_measured || !is_resolved(history)) return false;
  if (error.zone < 1.) return true;
  refined_ = Refined::zone;
  LevelRecord for_contact = history.back();
  for_contact.cells -= state_.cells_beside;
  const double flagged = flag(equilibrium, found.displacement, history);
  const bool result = growth_by<dim>(flagged, {for_contact}) > dear;
  for (const auto& cell : equilibrium.mesh().triangulation->active_cell_iterators())
    cell->clear_refine_flag();
  return result;
}

template <int dim>
State<dim> RefinementPass<dim>::refine(Equilibrium<dim>& equilibrium, const LevelState& found,
                                       State<dim> now, const History& history) {
  last_halvings_ = refined_ == Refined::zone ? 1 : 0;
  ++state_.n_refinements;
  now = equilibrium.refine(found.displacement, std::move(now));
  if (refined_ == Refined::nothing)
    return has_skipped_grading<dim>(history) ? grade(equilibrium, std::move(now), history) : now;
  if (next_pressure_is_of_no_use<dim>(history) && state_.n_refinements < settings_.max_levels) {
    const Vector guess = equilibrium.ghosted(now.displacement);
    flag(equilibrium, guess, history);
    ++state_.n_refinements;
    now = equilibrium.refine(guess, std::move(now));
    last_halvings_ = 2;
  }
  return make_zones_even(equilibrium, std::move(now));
}

/// Refines the cells around the contact until they are as small as the grading asks for.
template <int dim>
State<dim> RefinementPass<dim>::grade(Equilibrium<dim>& equilibrium, State<dim> now,
                                      const History& history) const {
  constexpr int most_passes = 12;
  for (int pass = 0; pass < most_passes; ++pass) {
    const Vector guess = equilibrium.ghosted(now.displacement);
    if (flag(equilibrium, guess, history) == 0.) break;
    now = equilibrium.refine(guess, std::move(now));
  }
  return now;
}

/// Ends where it helps little: cells that share a vertex differ by one level at most, so that
/// neighbours whose sizes differ by more cannot be made equal.
template <int dim>
State<dim> RefinementPass<dim>::make_zones_even(Equilibrium<dim>& equilibrium,
                                                State<dim> now) const {
  double before = std::numeric_limits<double>::max();
  while (true) {
    const double unevenness = unevenness_of(equilibrium.level());
    if (!(unevenness < minimum_gain * before)) break;
    if (flag_zone_part(*equilibrium.mesh().dof_handler, equilibrium.level().interfaces,
                       surface_ids_, ZonePart::uneven) == 0)
      break;
    const Vector guess = equilibrium.ghosted(now.displacement);
    now = equilibrium.refine(guess, std::move(now));
    if (dim == 2) before = unevenness;  // in 3-D the levels of a zone can always be made equal
  }
  return now;
}

template <int dim>
State<dim> RefinementPass<dim>::refine_open_contact(Equilibrium<dim>& equilibrium,
                                                    const LevelState& found, State<dim> now,
                                                    const History& history, const double length) {
  constexpr double same = 0.01;
  constexpr unsigned int settled = 3;
  const auto [pair, gap] = nearest_pair(found.contacts);
  state_.same_open_gaps =
      std::abs(gap - state_.open_gap) < same * gap ? state_.same_open_gaps + 1 : 0;
  if (state_.same_open_gaps == settled || state_.n_refinements >= settings_.max_levels)
    throw base::InputError(fmt::format(
        "contact pair {} stays open under {}, by {:.3g} m where it is nearest: there is no contact "
        "to analyse; check the load and the distance of the bodies{}",
        quoted(problem_.pairs[pair]),
        problem_.steps.empty() ? std::string("this load")
                               : fmt::format("load step {}, the last one", problem_.steps.size()),
        gap * length,
        problem_.steps.empty() ? "" : ", and let the load steps end with one that presses"));
  state_.open_gap = gap;
  equilibrium.touch_first();
  refined_ = Refined::zone;
  flag(equilibrium, found.displacement, history);
  ++state_.n_refinements;
  return equilibrium.refine(found.displacement, std::move(now));
}

template class RefinementPass<2>;
template class RefinementPass<3>;

}  // namespace geneva::fem
