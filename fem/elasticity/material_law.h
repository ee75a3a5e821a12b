#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "fem/elasticity/elasticity.h"

namespace geneva::fem {

/// d stress/d strain [Pa] by the components of StressVector; symmetric.
template <int dim>
using Tangent = Eigen::Matrix<double, n_stress_components<dim>, n_stress_components<dim>>;

/// What a material remembers at a point, such as plastic strains: as many numbers as its law needs.
using MaterialHistory = std::vector<double>;

/// A material's answer to a strain at a point.
template <int dim>
struct MaterialResponse {
  StressVector<dim> stress;
  Tangent<dim> tangent;
  MaterialHistory history;
};

/// What a material makes of strains, the only place that knows: cells and stresses ask here.
template <int dim>
class MaterialLaw {
 public:
  MaterialLaw() = default;
  MaterialLaw(const MaterialLaw&) = delete;
  MaterialLaw& operator=(const MaterialLaw&) = delete;
  virtual ~MaterialLaw() = default;

  /// @param strain with shears twice the tensor's; in a plane model without a hoop strain its
  /// third component is 0
  /// @param before at the end of the last instant; empty before the first
  [[nodiscard]] virtual MaterialResponse<dim> respond(const StressVector<dim>& strain,
                                                      const MaterialHistory& before) const = 0;

  /// Whether its response has a history.
  [[nodiscard]] virtual bool remembers() const { return false; }
};

/// Hooke's law; remembers nothing. In plane stress the out-of-plane stress is 0, whatever the third
/// strain.
template <int dim>
class LinearElastic : public MaterialLaw<dim> {
 public:
  /// @param plane not used in 3-D
  LinearElastic(const Material& material, PlaneKind plane);

  [[nodiscard]] MaterialResponse<dim> respond(const StressVector<dim>& strain,
                                              const MaterialHistory& before) const override;

 private:
  Tangent<dim> tangent_;
};

/// By body.
template <int dim>
using MaterialLaws = std::vector<std::unique_ptr<const MaterialLaw<dim>>>;

template <int dim>
MaterialLaws<dim> material_laws(const Problem<dim>& problem);

}  // namespace geneva::fem
