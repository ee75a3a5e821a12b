#include "fem/linear/multigrid/exchange.h"

#include <deal.II/base/index_set.h>

#include <algorithm>

namespace geneva::fem {

namespace {

dealii::IndexSet index_set(const std::vector<int>& unknowns, const UnknownRanges& of_all) {
  dealii::IndexSet result(static_cast<dealii::types::global_dof_index>(of_all.n_all()));
  result.add_indices(unknowns.begin(), unknowns.end());
  result.compress();
  return result;
}

}  // namespace

Exchange::Exchange(const UnknownRanges& unknowns, const std::vector<int>& others)
    : partitioner_(unknowns.own(), index_set(others, unknowns), unknowns.communicator()),
      at_others_(others.size()),
      at_own_(partitioner_.n_import_indices()) {}

void Exchange::begin_to_receive(const double* const own) {
  partitioner_.export_to_ghosted_array_start(
      0, dealii::ArrayView<const double>(own, partitioner_.locally_owned_size()),
      dealii::ArrayView<double>(at_own_.data(), at_own_.size()),
      dealii::ArrayView<double>(at_others_.data(), at_others_.size()), requests_);
}

const double* Exchange::end_of_receiving() {
  partitioner_.export_to_ghosted_array_finish(
      dealii::ArrayView<double>(at_others_.data(), at_others_.size()), requests_);
  return at_others_.data();
}

double* Exchange::to_send() {
  std::fill(at_others_.begin(), at_others_.end(), 0.);
  return at_others_.data();
}

void Exchange::begin_to_send() {
  partitioner_.import_from_ghosted_array_start(
      dealii::VectorOperation::add, 0,
      dealii::ArrayView<double>(at_others_.data(), at_others_.size()),
      dealii::ArrayView<double>(at_own_.data(), at_own_.size()), requests_);
}

void Exchange::add_received(double* const own) {
  partitioner_.import_from_ghosted_array_finish(
      dealii::VectorOperation::add, dealii::ArrayView<const double>(at_own_.data(), at_own_.size()),
      dealii::ArrayView<double>(own, partitioner_.locally_owned_size()),
      dealii::ArrayView<double>(at_others_.data(), at_others_.size()), requests_);
}

}  // namespace geneva::fem
