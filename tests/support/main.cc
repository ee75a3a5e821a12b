#include <gtest/gtest.h>

#include <deal.II/base/mpi.h>

#include <iostream>
#include <string>

namespace {

/// Tells of failures only: for all ranks but the first.
class FailurePrinter : public testing::EmptyTestEventListener {
  void OnTestStart(const testing::TestInfo& test) override {
    name_ = std::string(test.test_suite_name()) + '.' + test.name();
  }

  void OnTestPartResult(const testing::TestPartResult& result) override {
    if (!result.failed()) return;
    std::cerr << "rank " << dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) << ", "
              << name_ << ": " << (result.file_name() == nullptr ? "" : result.file_name()) << ':'
              << result.line_number() << ": " << result.message() << std::endl;
  }

  std::string name_;
};

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) > 0) {
    testing::TestEventListeners& listeners = testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());
    listeners.Append(new FailurePrinter);
  }
  const int failed = RUN_ALL_TESTS();
  // A rank that succeeded must not hide another one's failure.
  return dealii::Utilities::MPI::max(failed, MPI_COMM_WORLD);
}
