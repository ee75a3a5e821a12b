#pragma once

#include "fem/discretisation/vector.h"

namespace geneva::fem {

/// Approximate inverse of a condensed stiffness whose constraints change with the active set.
class Preconditioner {
 public:
  Preconditioner() = default;
  Preconditioner(const Preconditioner&) = delete;
  Preconditioner& operator=(const Preconditioner&) = delete;
  virtual ~Preconditioner() = default;

  /// Symmetric and positive definite, so that conjugate gradients can use it.
  virtual void vmult(Vector& correction, const Vector& residual) const = 0;

  /// To be called when other unknowns of the matrix are constrained.
  virtual void renew() = 0;

  /// Whether the matrix is positive definite, as far as that was found out.
  [[nodiscard]] virtual bool is_definite() const { return true; }
};

}  // namespace geneva::fem
