#include "fem/contact/mortar.h"

#include <deal.II/base/mpi.h>

#include <Eigen/Core>
#include <cmath>
#include <map>
#include <optional>

#include "fem/discretisation/gather.h"
#include "mesh/dense_algebra.h"

namespace geneva::fem {

using dealii::Tensor;

namespace {

/// Share of a source node's faces that must be covered by the target for the node to take part in
/// the contact: where a pin sticks out of its slot, layers beyond the wheel's face are covered to
/// 1e-5 to 5e-4.
constexpr double minimum_coverage = 1e-3;
/// Of a node of which less is covered the gap is the mean over what is covered, weighted by its
/// shape function: the dual one extrapolates to the node, as many times farther as less is covered.
/// Where the target bends away, a node a diameter beside the contact was found to be closed.
constexpr double extrapolated_coverage = 0.1;
/// Below this reciprocal condition the covered sliver of a face is too thin for a basis of its own.
constexpr double minimum_condition = 1e-14;

/// Couplings below this share of a row's weight are roundings, which reach 1e-13: between a node
/// and those of other layers, where the two surfaces have the same layers.
constexpr double minimum_coupling = 1e-12;

template <int dim>
using FaceMatrix = Eigen::Matrix<double, n_face_nodes<dim>, n_face_nodes<dim>>;

/// Coefficients A = D_e M_e^-1 of the dual basis psi_i = sum_k A_ik N_k on the covered part of one
/// face.
template <int dim>
std::optional<FaceMatrix<dim>> dual_basis(const std::vector<OverlapPoint<dim>>& points) {
  if (points.empty()) return std::nullopt;
  FaceMatrix<dim> mass = FaceMatrix<dim>::Zero();
  for (const OverlapPoint<dim>& p : points) {
    const Eigen::Map<const Eigen::Matrix<double, n_face_nodes<dim>, 1>> shapes(
        p.source_shapes.data());
    mass += p.weight * shapes * shapes.transpose();
  }
  const std::optional<Eigen::MatrixXd> inverse = mesh::inverse(mass, minimum_condition);
  if (!inverse) return std::nullopt;
  // the shape functions sum to 1, so that the rows of M sum to D
  return FaceMatrix<dim>(mass.rowwise().sum().asDiagonal() * *inverse);
}

/// A row under construction.
template <int dim>
struct RowSum {
  double weight = 0.;
  double full_weight = 0.;
  Tensor<1, dim> normal;
  double gap = 0.;
  double covered_gap = 0.;  ///< weighted by the shape function instead of the dual one
  std::map<unsigned int, double> coupling;
};

template <int dim>
void add_face(const Surface<dim>& source, const SurfaceFace<dim>& face,
              const FaceSearch<dim>& search, const MortarData<dim>& data,
              std::vector<RowSum<dim>>& rows) {
  constexpr std::size_t n = n_face_nodes<dim>;
  const double share = face_weight(source, face, data) / n;
  for (const unsigned int node : face.nodes) rows[node].full_weight += share;

  const auto points = overlap_points(source, face, search, data);
  const auto basis = dual_basis<dim>(points);
  if (!basis) return;
  for (const OverlapPoint<dim>& p : points)
    for (std::size_t i = 0; i < n; ++i) {
      double psi = 0.;
      for (std::size_t k = 0; k < n; ++k)
        psi += (*basis)(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) *
               p.source_shapes[k];
      RowSum<dim>& row = rows[face.nodes[i]];
      row.weight += p.weight * p.source_shapes[i];
      row.normal += p.weight * psi * p.normal;
      row.gap += p.weight * psi * p.gap;
      row.covered_gap += p.weight * p.source_shapes[i] * p.gap;
      for (std::size_t k = 0; k < n; ++k)
        row.coupling[p.target_nodes[k]] += p.weight * psi * p.target_shapes[k];
    }
}

/// The couplings without those that are roundings.
template <int dim>
std::vector<std::pair<unsigned int, double>> couplings(const RowSum<dim>& sum) {
  std::vector<std::pair<unsigned int, double>> result;
  for (const auto& [target, coupling] : sum.coupling)
    if (std::abs(coupling) > minimum_coupling * sum.weight) result.emplace_back(target, coupling);
  return result;
}

/// Rows as flat vectors, which is what travels between the ranks.
struct PackedRows {
  std::vector<unsigned int> integers;
  std::vector<double> reals;
};

template <int dim>
PackedRows packed(const std::vector<RowSum<dim>>& rows) {
  PackedRows result;
  for (unsigned int node = 0; node < rows.size(); ++node) {
    const RowSum<dim>& row = rows[node];
    if (row.full_weight == 0.) continue;
    result.integers.push_back(node);
    result.integers.push_back(static_cast<unsigned int>(row.coupling.size()));
    result.reals.insert(result.reals.end(),
                        {row.weight, row.full_weight, row.gap, row.covered_gap});
    for (unsigned int component = 0; component < dim; ++component)
      result.reals.push_back(row.normal[component]);
    for (const auto& [target, coupling] : row.coupling) {
      result.integers.push_back(target);
      result.reals.push_back(coupling);
    }
  }
  return result;
}

template <int dim>
void add_packed(const PackedRows& packed, std::vector<RowSum<dim>>& rows) {
  auto real = packed.reals.begin();
  for (auto integer = packed.integers.begin(); integer != packed.integers.end();) {
    RowSum<dim>& row = rows[*integer++];
    const unsigned int couplings = *integer++;
    row.weight += *real++;
    row.full_weight += *real++;
    row.gap += *real++;
    row.covered_gap += *real++;
    for (unsigned int component = 0; component < dim; ++component) row.normal[component] += *real++;
    for (unsigned int i = 0; i < couplings; ++i) row.coupling[*integer++] += *real++;
  }
}

/// Sums over this rank's share of the faces, then over the ranks in their order.
template <int dim>
std::vector<RowSum<dim>> row_sums(const Surface<dim>& source, const Surface<dim>& target,
                                  const MortarData<dim>& data) {
  const std::size_t ranks = dealii::Utilities::MPI::n_mpi_processes(data.communicator);
  const std::size_t rank = dealii::Utilities::MPI::this_mpi_process(data.communicator);
  const std::size_t n_faces = source.faces.size();
  const FaceSearch<dim> search(target);
  std::vector<RowSum<dim>> own(source.nodes.size());
  for (std::size_t i = rank * n_faces / ranks; i < (rank + 1) * n_faces / ranks; ++i)
    add_face(source, source.faces[i], search, data, own);
  if (ranks == 1) return own;
  std::vector<RowSum<dim>> sums(source.nodes.size());
  const PackedRows parts = packed(own);
  add_packed<dim>(
      {gathered(data.communicator, parts.integers), gathered(data.communicator, parts.reals)},
      sums);
  return sums;
}

}  // namespace

template <int dim>
std::vector<ContactRow<dim>> mortar_rows(const Surface<dim>& source, const Surface<dim>& target,
                                         const MortarData<dim>& data) {
  const std::vector<RowSum<dim>> sums = row_sums(source, target, data);
  std::vector<ContactRow<dim>> rows;
  for (unsigned int node = 0; node < sums.size(); ++node) {
    const RowSum<dim>& sum = sums[node];
    if (sum.weight <= minimum_coverage * sum.full_weight) continue;
    const bool is_extrapolated = sum.weight < extrapolated_coverage * sum.full_weight;
    rows.push_back({node, sum.weight, frame_along(sum.normal / sum.normal.norm()),
                    is_extrapolated ? sum.covered_gap : sum.gap, couplings(sum)});
  }
  return rows;
}

template std::vector<ContactRow<2>> mortar_rows(const Surface<2>&, const Surface<2>&,
                                                const MortarData<2>&);
template std::vector<ContactRow<3>> mortar_rows(const Surface<3>&, const Surface<3>&,
                                                const MortarData<3>&);

}  // namespace geneva::fem
