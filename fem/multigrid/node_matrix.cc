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
      of_each_(static_cast<std::size_t>(of_each)),
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
  const Epetra_Map others = columns_.unknowns_of_others(of_each, unknowns.Comm());
  import_ = std::make_unique<Epetra_Import>(others, unknowns_);
  others_ = std::make_unique<Epetra_MultiVector>(others, 1);
}

std::size_t NodePattern::block(const std::size_t row, const int place) const {
  const auto begin = places_.begin() + static_cast<std::ptrdiff_t>(first_blocks_[row]);
  const auto end = places_.begin() + static_cast<std::ptrdiff_t>(first_blocks_[row + 1]);
  return static_cast<std::size_t>(std::lower_bound(begin, end, place) - places_.begin());
}

const double* NodePattern::on_others(const Epetra_MultiVector& of_own) const {
  if (!import_) return nullptr;
  others_->Import(of_own, *import_, Insert);
  return (*others_)[0];
}

std::vector<double> NodePattern::on_all_nodes(const std::vector<double>& of_own_nodes) const {
  Epetra_MultiVector own(unknowns_, 1);
  for (std::size_t node = 0; node < of_own_nodes.size(); ++node)
    own[0][node * of_each_] = of_own_nodes[node];
  const double* const others = on_others(own);
  std::vector<double> result = of_own_nodes;
  for (std::size_t node = own_.size(); node < n_places(); ++node)
    result.push_back(others[(node - own_.size()) * of_each_]);
  return result;
}

void NodePattern::sum(Epetra_MultiVector& of_own,
                      const std::function<void(double*, double*)>& add) const {
  of_own.PutScalar(0.);
  this->add(of_own, add);
}

void NodePattern::add(Epetra_MultiVector& of_own,
                      const std::function<void(double*, double*)>& add) const {
  if (!import_) return add(of_own[0], nullptr);
  others_->PutScalar(0.);
  add(of_own[0], (*others_)[0]);
  of_own.Export(*others_, *import_, Add);
}

template <int n, int m>
void NodeMatrix<n, m>::add(const std::size_t row, const BlockRow<Block>& values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    blocks_[pattern_.block(row, pattern_.place_of(values.number(i)))] += values.block(i);
}

template <int n, int m>
void NodeMatrix<n, m>::vmult_add(Vector& result, const Vector& vector) const {
  using Part = Eigen::Matrix<double, m, 1>;
  const double* const own = vector.trilinos_vector()[0];
  const double* const others = pattern_.on_others(vector.trilinos_vector());
  double* const to = result.trilinos_vector()[0];
  const auto n_own = static_cast<int>(pattern_.own().size());
  for (std::size_t row = 0; row < pattern_.n_rows(); ++row) {
    Eigen::Map<Eigen::Matrix<double, n, 1>> sum(to + n * row);
    for (std::size_t i = pattern_.first_block(row); i < pattern_.first_block(row + 1); ++i) {
      const int place = pattern_.place(i);
      const double* const values = place < n_own ? own + m * place : others + m * (place - n_own);
      sum.noalias() += blocks_[i] * Eigen::Map<const Part>(values);
    }
  }
}

template <int n, int m>
void NodeMatrix<n, m>::Tvmult(Vector& result, const Vector& vector) const {
  const double* const from = vector.trilinos_vector()[0];
  const auto n_own = static_cast<int>(pattern_.own().size());
  pattern_.sum(result.trilinos_vector(), [&](double* const own, double* const others) {
    for (std::size_t row = 0; row < pattern_.n_rows(); ++row) {
      const Eigen::Map<const Eigen::Matrix<double, n, 1>> of_row(from + n * row);
      for (std::size_t i = pattern_.first_block(row); i < pattern_.first_block(row + 1); ++i) {
        const int place = pattern_.place(i);
        double* const to = place < n_own ? own + m * place : others + m * (place - n_own);
        Eigen::Map<Eigen::Matrix<double, m, 1>>(to).noalias() += blocks_[i].transpose() * of_row;
      }
    }
  });
}

template <int n, int m>
NodeMatrix<n, m> matrix_of(const std::vector<BlockRow<Eigen::Matrix<double, n, m>>>& rows,
                           const Epetra_Map& unknowns) {
  std::vector<std::vector<int>> coupled;
  for (const auto& row : rows) coupled.push_back(row.numbers());
  NodeMatrix<n, m> matrix(NodePattern(unknowns, m, std::move(coupled)));
  for (std::size_t row = 0; row < rows.size(); ++row) matrix.add(row, rows[row]);
  return matrix;
}

template class NodeMatrix<2, 3>;
template class NodeMatrix<3, 3>;
template class NodeMatrix<3, 6>;
template class NodeMatrix<6, 6>;
template NodeMatrix<2, 3> matrix_of(const std::vector<BlockRow<Eigen::Matrix<double, 2, 3>>>&,
                                    const Epetra_Map&);
template NodeMatrix<3, 3> matrix_of(const std::vector<BlockRow<Eigen::Matrix3d>>&,
                                    const Epetra_Map&);
template NodeMatrix<3, 6> matrix_of(const std::vector<BlockRow<Eigen::Matrix<double, 3, 6>>>&,
                                    const Epetra_Map&);
template NodeMatrix<6, 6> matrix_of(const std::vector<BlockRow<Eigen::Matrix<double, 6, 6>>>&,
                                    const Epetra_Map&);

}  // namespace geneva::fem
