#include "fem/element.h"

#include <deal.II/fe/fe_q.h>

#include <new>

#include "base/allocation.h"

namespace geneva::fem {

template <int dim>
std::unique_ptr<dealii::FESystem<dim>> linear_element(const unsigned int n_components) {
  const unsigned long failures = base::failed_allocations();
  const auto require_memory = [&] {
    if (base::failed_allocations() != failures) throw std::bad_alloc();
  };
  const dealii::FE_Q<dim> of_component(1);
  require_memory();
  auto element = std::make_unique<dealii::FESystem<dim>>(of_component, n_components);
  require_memory();
  return element;
}

template std::unique_ptr<dealii::FESystem<2>> linear_element(unsigned int);
template std::unique_ptr<dealii::FESystem<3>> linear_element(unsigned int);

}  // namespace geneva::fem
