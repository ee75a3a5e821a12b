#include "fem/contact/contact_law.h"

#include <cmath>

namespace geneva::fem {

namespace {

template <int dim>
bool touches(const NodeContact<dim>& node, const ContactRounding& rounding) {
  return is_closed(node.status) ? node.traction[0] >= -rounding.pressure
                                : node.gap[0] < -rounding.gap;
}

/// Along the tangents.
template <int dim>
double tangential_product(const Components<dim>& one, const Components<dim>& other) {
  double product = 0.;
  for (std::size_t i = 1; i < dim; ++i) product += one[i] * other[i];
  return product;
}

template <int dim>
double tangential_norm(const Components<dim>& components) {
  return std::sqrt(tangential_product<dim>(components, components));
}

/// The unit vector along the tangential part, turned by a sign; 0 of 0.
template <int dim>
Components<dim> tangential_direction(const Components<dim>& components, const double sign) {
  const double norm = tangential_norm<dim>(components);
  Components<dim> direction{};
  if (norm > 0.)
    for (std::size_t i = 1; i < dim; ++i) direction[i] = sign * components[i] / norm;
  return direction;
}

/// Gap 0 where closed, no traction where open, no friction.
template <int dim>
ContactEquations<dim> frictionless_equations(const NodeContact<dim>& node) {
  ContactEquations<dim> result;
  for (std::size_t direction = 0; direction < dim; ++direction) {
    const bool is_gap = direction == 0 && is_closed(node.status);
    result.residual[direction] = is_gap ? node.gap[direction] : node.traction[direction];
    (is_gap ? result.by_gap : result.by_traction)[direction][direction] = 1.;
  }
  return result;
}

}  // namespace

template <int dim>
NodeStatus Frictionless<dim>::next_status(const NodeContact<dim>& node,
                                          const ContactRounding& rounding) const {
  return touches(node, rounding) ? NodeStatus::slip : NodeStatus::open;
}

template <int dim>
ContactEquations<dim> Frictionless<dim>::equations(const NodeContact<dim>& node) const {
  return frictionless_equations(node);
}

template <int dim>
Sliding<dim>::Sliding(const double coefficient) : coefficient_(coefficient) {}

template <int dim>
NodeStatus Sliding<dim>::next_status(const NodeContact<dim>& node,
                                     const ContactRounding& rounding) const {
  return touches(node, rounding) ? NodeStatus::slip : NodeStatus::open;
}

/// friction + mu pressure sliding = 0.
template <int dim>
ContactEquations<dim> Sliding<dim>::equations(const NodeContact<dim>& node) const {
  ContactEquations<dim> result = frictionless_equations(node);
  if (!is_closed(node.status)) return result;
  for (std::size_t i = 1; i < dim; ++i) {
    result.residual[i] += coefficient_ * node.traction[0] * node.sliding[i];
    result.by_traction[i][0] = coefficient_ * node.sliding[i];
  }
  return result;
}

template <int dim>
NodeStatus Coulomb<dim>::next_status(const NodeContact<dim>& node,
                                     const ContactRounding& rounding) const {
  if (!touches(node, rounding)) return NodeStatus::open;
  switch (node.status) {
    case NodeStatus::stick: {
      const double bound = this->coefficient() * (node.traction[0] + rounding.pressure);
      return tangential_norm<dim>(node.traction) > bound ? NodeStatus::slip : NodeStatus::stick;
    }
    case NodeStatus::slip:
      return tangential_product<dim>(node.gap, node.sliding) < -rounding.gap ? NodeStatus::stick
                                                                             : NodeStatus::slip;
    default:  // what slides past faster than it closes does not stick at once
      return tangential_norm<dim>(node.gap) > this->coefficient() * std::abs(node.gap[0])
                 ? NodeStatus::slip
                 : NodeStatus::stick;
  }
}

/// Of a node that closes along its slip, of one that stuck against the friction that held it.
template <int dim>
Components<dim> Coulomb<dim>::next_sliding(const NodeContact<dim>& node) const {
  if (node.status == NodeStatus::open) return tangential_direction<dim>(node.gap, 1.);
  if (node.status == NodeStatus::stick) return tangential_direction<dim>(node.traction, -1.);
  return node.sliding;
}

template <int dim>
ContactEquations<dim> Coulomb<dim>::equations(const NodeContact<dim>& node) const {
  if (node.status != NodeStatus::stick) return Sliding<dim>::equations(node);
  ContactEquations<dim> result;
  for (std::size_t direction = 0; direction < dim; ++direction) {
    result.residual[direction] = node.gap[direction];
    result.by_gap[direction][direction] = 1.;
  }
  return result;
}

template class Frictionless<2>;
template class Frictionless<3>;
template class Sliding<2>;
template class Sliding<3>;
template class Coulomb<2>;
template class Coulomb<3>;

}  // namespace geneva::fem
