#include "fem/contact/contact_law.h"

namespace geneva::fem {

template <int dim>
NodeStatus Frictionless<dim>::next_status(const NodeContact<dim>& node,
                                          const ContactRounding& rounding) const {
  const bool touches =
      is_closed(node.status) ? node.traction[0] >= -rounding.pressure : node.gap[0] < -rounding.gap;
  return touches ? NodeStatus::slip : NodeStatus::open;
}

template <int dim>
ContactEquations<dim> Frictionless<dim>::equations(const NodeContact<dim>& node) const {
  ContactEquations<dim> result;
  for (std::size_t direction = 0; direction < dim; ++direction) {
    const bool is_gap = direction == 0 && is_closed(node.status);
    result.residual[direction] = is_gap ? node.gap[direction] : node.traction[direction];
    (is_gap ? result.by_gap : result.by_traction)[direction][direction] = 1.;
  }
  return result;
}

template class Frictionless<2>;
template class Frictionless<3>;

}  // namespace geneva::fem
