#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <optional>
#include <utility>

#include "fem/checkpoint.h"

namespace geneva::fem {

/// The last mesh that was solved, for when memory runs out on a finer one.
template <int dim>
class LastMesh {
 public:
  void keep(Checkpoint<dim> checkpoint) {
    keep_reserve(checkpoint.history.back().dofs);
    checkpoint_ = std::move(checkpoint);
  }

  /// Gives the reserve back, and the checkpoint, if there is one.
  std::optional<Checkpoint<dim>> take() {
    reserve_.reset();
    return std::move(checkpoint_);
  }

 private:
  /// What the results of a mesh take to be written: resident memory grows by 480 bytes per unknown
  /// then (measured in 3-D, with 57 000), and the mesh has to be made again before. The reserve
  /// is never touched: it takes addresses only, which are what runs out when an allocation fails.
  void keep_reserve(const std::size_t unknowns) {
    constexpr std::size_t least = 16U << 20U;
    reserve_.reset();
    for (std::size_t size = least + 1000 * unknowns; !reserve_ && size >= least; size /= 2)
      reserve_.reset(new (std::nothrow) char[size]);
  }

  std::optional<Checkpoint<dim>> checkpoint_;
  std::unique_ptr<char[]> reserve_;
};

}  // namespace geneva::fem
