#include "fem/linear/multigrid/exchange.h"

#include <deal.II/base/index_set.h>

#include <Epetra_MpiComm.h>

#include <algorithm>

namespace geneva::fem {

namespace {

dealii::IndexSet index_set(const std::vector<int>& unknowns, const Epetra_Map& of_all) {
  dealii::IndexSet result(static_cast<dealii::types::global_dof_index>(of_all.NumGlobalElements()));
  result.add_indices(unknowns.begin(), unknowns.end());
  result.compress();
  return result;
}

MPI_Comm communicator_of(const Epetra_Map& unknowns) {
  return dynamic_cast<const Epetra_MpiComm&>(unknowns.Comm()).Comm();
}

}  // namespace

Exchange::Exchange(const Epetra_Map& unknowns, const std::vector<int>& others)
    : partitioner_(dealii::IndexSet(unknowns), index_set(others, unknowns),
                   communicator_of(unknowns)),
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
