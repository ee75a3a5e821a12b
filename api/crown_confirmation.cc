#include "api/crown_confirmation.h"

#include "api/mesher_on_rank_zero.h"
#include "api/told_together.h"
#include "fem/contact_problem.h"
#include "model/model.h"
#include "model/naming.h"
#include "post/analysis/load_evenness.h"
#include "post/analysis/results.h"

namespace geneva {

bool confirm(Crown& crown, const MPI_Comm communicator, mesh::Mesher* const started,
             const Progress& progress) {
  api::MesherOnRankZero on_rank_zero(communicator, started);
  const Case& best = crown.best;
  fem::Progress<3> watch;
  watch.step = told_together(communicator, progress.step);
  watch.level = told_together(communicator, progress.mesh);
  watch.work = told_together(communicator, progress.work);
  return model::naming(best, [&] {
    const model::Model<3> model = model::make_model<3>(communicator, best, on_rank_zero.get());
    const fem::Solution<3> solution =
        fem::solve_contact(communicator, model.mesh, model.problem, best.settings, watch);
    crown.report.confirmed = post::load_evenness(solution, post::analyse(solution));
    return fem::is_success(solution.stop.outcome);
  });
}

}  // namespace geneva
