#include <gtest/gtest.h>

#include <deal.II/base/mpi.h>

#include <iostream>

namespace {

/// Tells of failures only: for all ranks but the first.
class FailurePrinter : public testing::EmptyTestEventListener {
  void OnTestPartResult(const testing::TestPartResult& result) override {
    if (!result.failed()) return;
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    std::cerr << "rank " << dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) << ", "
              << (test == nullptr ? "" : test->name()) << ": " << result.file_name() << ':'
              << result.line_number() << ": " << result.message() << std::endl;
  }
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
