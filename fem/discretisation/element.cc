#include "fem/discretisation/element.h"

#include <deal.II/fe/fe_q.h>

#include "base/allocation.h"

namespace geneva::fem {

template <int dim>
std::unique_ptr<dealii::FESystem<dim>> linear_element(const unsigned int n_components) {
  base::AllocationWatch allocations;
  const dealii::FE_Q<dim> of_component(1);
  allocations.require_none();
  auto element = std::make_unique<dealii::FESystem<dim>>(of_component, n_components);
  allocations.require_none();
  return element;
}

template std::unique_ptr<dealii::FESystem<2>> linear_element(unsigned int);
template std::unique_ptr<dealii::FESystem<3>> linear_element(unsigned int);

}  // namespace geneva::fem
