#pragma once

#include <map>
#include <optional>
#include <vector>

#include "post/analysis/results.h"

namespace geneva::post {

/// A figure of the closing table beside the peak pressure.
enum class Figure {
  force,
  half_width,
  half_length,          ///< in 3-D
  max_shear,            ///< maximum shear below the contact
  max_shear_depth,      ///< its depth
  surface_tension,      ///< in the plane, with friction
  mid_length_pressure,  ///< in 3-D, as all below: maximum pressure of the middle section
  mid_length_shear,     ///< maximum shear below the middle section
  mid_length_shear_depth,
  line_load_middle,
  line_load_end,  ///< at the more heavily loaded end
  bore_torque,    ///< of mechanisms, as all below
  tip_deflection,
  slope,
  root_stress,
  section_moment  ///< of the pin as meshed, over the circle's: 1 in the limit
};

/// Values of figures in SI units, or their relative errors.
using Figures = std::map<Figure, double>;

/// What they hold of one, if anything.
std::optional<double> value_of(const Figures& figures, Figure figure);

/// Figures of a run.
struct RunFigures {
  std::vector<Figures> contacts;  ///< by contact pair
  Figures mechanism;              ///< of mechanisms, those that belong to no contact
};

/// The figures of a contact.
Figures figures(const fem::ContactResult<2>& contact, const ContactAnalysis<2>& analysis);
Figures figures(const fem::ContactResult<3>& contact, const ContactAnalysis<3>& analysis);

/// The contacts' figures of a solution.
/// @param cells its stresses
template <int dim>
RunFigures contact_figures(const fem::Solution<dim>& solution,
                           const std::vector<CellStress<dim>>& cells);

/// Estimated relative errors of the figures on the last mesh: what their changes from mesh to mesh
/// leave (theory, section 5.3), and what lies between the nodes and cells that they are taken from.
/// @param meshes figures on every mesh of the solution's history
template <int dim>
RunFigures figure_errors(const fem::Solution<dim>& solution, const std::vector<RunFigures>& meshes);

}  // namespace geneva::post
