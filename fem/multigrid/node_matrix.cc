#include "fem/multigrid/node_matrix.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace geneva::fem {

namespace {

std::vector<int> others_in(const std::vector<std::vector<int>>& lists, const OwnNodes& own) {
  std::vector<int> others;
  for (const auto& list : lists)
    std::copy_if(list.begin(), list.end(), std::back_inserter(others),
                 [&](const int number) { return !own.have(number); });
  return others;
}

}  // namespace

NodePattern::NodePattern(const Epetra_Map& unknowns, const int of_each,
                         std::vector<std::vector<int>> coupled)
    : unknowns_(unknowns),
      own_(unknowns, of_each),
      columns_(own_, others_in(coupled, own_)),
      numbers_(columns_.numbers()),
      first_blocks_{0} {
  first_blocks_.reserve(coupled.size() + 1);
  for (const auto& list : coupled) first_blocks_.push_back(first_blocks_.back() + list.size());
  places_.reserve(first_blocks_.back());
  for (const auto& list : coupled) {
    const auto first = static_cast<std::ptrdiff_t>(places_.size());
    for (const int number : list) places_.push_back(columns_.place_of(number));
    std::sort(places_.begin() + first, places_.end());
  }
  if (unknowns.Comm().NumProc() == 1) return;
  const Epetra_Map all = columns_.unknowns(of_each, unknowns.Comm());
  import_ = std::make_unique<Epetra_Import>(all, unknowns_);
  all_ = std::make_unique<Epetra_MultiVector>(all, 1);
}

std::size_t NodePattern::block(const std::size_t own_place, const int place) const {
  const auto begin = places_.begin() + static_cast<std::ptrdiff_t>(first_blocks_[own_place]);
  const auto end = places_.begin() + static_cast<std::ptrdiff_t>(first_blocks_[own_place + 1]);
  return static_cast<std::size_t>(std::lower_bound(begin, end, place) - places_.begin());
}

const double* NodePattern::on_all_places(const Epetra_MultiVector& of_own) const {
  if (!import_) return of_own[0];
  all_->Import(of_own, *import_, Insert);
  return (*all_)[0];
}

template <int n>
void NodeMatrix<n>::add(const BlockRows<Block>& rows) {
  for (const auto& [number, row] : rows) {
    const auto own_place = static_cast<std::size_t>(number - pattern_.own().first);
    for (std::size_t i = 0; i < row.size(); ++i)
      blocks_[pattern_.block(own_place, pattern_.place_of(row.number(i)))] += row.block(i);
  }
}

template <int n>
template <typename Use>
void NodeMatrix<n>::multiply(const Vector& vector, const Use& use) const {
  using Part = Eigen::Matrix<double, n, 1>;
  const double* const values = pattern_.on_all_places(vector.trilinos_vector());
  for (std::size_t row = 0; row < pattern_.own().size(); ++row) {
    Part sum = Part::Zero();
    for (std::size_t i = pattern_.first_block(row); i < pattern_.first_block(row + 1); ++i)
      sum.noalias() += blocks_[i] * Eigen::Map<const Part>(values + n * pattern_.place(i));
    for (int component = 0; component < n; ++component)
      use(n * row + static_cast<std::size_t>(component), sum[component]);
  }
}

template <int n>
void NodeMatrix<n>::vmult(Vector& result, const Vector& vector) const {
  double* const to = result.trilinos_vector()[0];
  multiply(vector, [&](const std::size_t unknown, const double value) { to[unknown] = value; });
}

template <int n>
void NodeMatrix<n>::vmult_add(Vector& result, const Vector& vector) const {
  double* const to = result.trilinos_vector()[0];
  multiply(vector, [&](const std::size_t unknown, const double value) { to[unknown] += value; });
}

template <int n>
void NodeMatrix<n>::residual(Vector& result, const Vector& vector,
                             const Vector& right_hand_side) const {
  double* const to = result.trilinos_vector()[0];
  const double* const from = right_hand_side.trilinos_vector()[0];
  multiply(vector, [&](const std::size_t unknown, const double value) {
    to[unknown] = from[unknown] - value;
  });
}

template <int n>
std::vector<double> NodeMatrix<n>::diagonal() const {
  std::vector<double> result;
  result.reserve(n * pattern_.own().size());
  for (std::size_t row = 0; row < pattern_.own().size(); ++row) {
    const Block& block = blocks_[pattern_.block(row, static_cast<int>(row))];
    for (int component = 0; component < n; ++component)
      result.push_back(block(component, component));
  }
  return result;
}

template class NodeMatrix<2>;
template class NodeMatrix<3>;

}  // namespace geneva::fem
