#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "post/analysis/comparison.h"
#include "post/analysis/safety.h"
#include "tests/support/line_contact.h"
#include "tests/support/solving.h"

namespace geneva::post {

constexpr double wanted_accuracy = 0.01;

/// A run with the errors that it estimates of its figures.
struct Cylinder {
  Cylinder(const test::LineContact& contact, const fem::Friction& friction) {
    fem::Problem<2> problem = test::problem_of(contact);
    problem.pairs.front().friction = friction;
    std::vector<RunFigures> meshes;
    fem::Progress<2> progress;
    progress.solution = [&](const fem::Solution<2>& on_mesh) {
      meshes.push_back(contact_figures(on_mesh, analyse(on_mesh).cells));
    };
    solution = fem::solve_contact(MPI_COMM_WORLD, test::mesh_of(contact), problem,
                                  test::with_accuracy(wanted_accuracy), progress);
    results = analyse(solution);
    errors.errors = figure_errors(solution, meshes);
  }

  [[nodiscard]] ComparisonRow row(const std::string& quantity, const RunReport& report) const {
    const auto rows = comparison(solution, results, report);
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const ComparisonRow& one) {
      return one.quantity == quantity;
    });
    if (found == rows.end()) throw std::out_of_range(quantity);
    return *found;
  }

  [[nodiscard]] ComparisonRow row(const std::string& quantity) const {
    return row(quantity, errors);
  }

  [[nodiscard]] std::optional<SafetyRow> limit(const std::string& quantity,
                                               const RunReport& report) const {
    for (const SafetyRow& row : safety(solution, results, report))
      if (row.quantity == quantity) return row;
    return std::nullopt;
  }

  [[nodiscard]] double peak() const { return solution.contacts.front().peak_pressure; }

  fem::Solution<2> solution;
  Results<2> results;
  RunReport errors{};  ///< a report with nothing but them
};

constexpr double mu = 0.3;

/// Solved once, and gone before MPI is.
class CylinderOnABlock : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    pressed_ = std::make_unique<Cylinder>(test::LineContact{}, fem::Friction{});
    sliding_ = std::make_unique<Cylinder>(test::LineContact{}, fem::Friction{mu, {1., 0., 0.}});
  }
  static void TearDownTestSuite() {
    pressed_.reset();
    sliding_.reset();
  }

  static const Cylinder& pressed() { return *pressed_; }
  static const Cylinder& sliding() { return *sliding_; }  ///< towards +x

 private:
  static inline std::unique_ptr<Cylinder> pressed_;
  static inline std::unique_ptr<Cylinder> sliding_;
};

}  // namespace geneva::post
