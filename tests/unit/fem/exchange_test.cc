#include "fem/linear/multigrid/exchange.h"

#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include <vector>

namespace geneva::fem::test {
namespace {

/// Three unknowns on each rank, each of which has the last ones of all the others in its exchange.
class RanksWithThreeUnknowns : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<int> last_of_others() const {
    std::vector<int> result;
    for (int rank = 0; rank < n_ranks; ++rank)
      if (rank != this_rank) result.push_back(3 * rank + 2);
    return result;
  }

  const int n_ranks = static_cast<int>(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));
  const int this_rank = static_cast<int>(dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD));
  Exchange exchange{UnknownRanges(3, MPI_COMM_WORLD), last_of_others()};
};

TEST_F(RanksWithThreeUnknowns, ReceiveTheValuesOfOthersEachTime) {
  for (const double factor : {1., 10.}) {
    const double first = 3. * this_rank;
    const std::vector<double> own{factor * first, factor * (first + 1.), factor * (first + 2.)};
    exchange.begin_to_receive(own.data());
    const double* const received = exchange.end_of_receiving();
    const std::vector<int> others = last_of_others();
    for (std::size_t i = 0; i < others.size(); ++i) EXPECT_EQ(received[i], factor * others[i]);
  }
}

TEST_F(RanksWithThreeUnknowns, AddWhatOthersSendEachTime) {
  for (const double factor : {1., 10.}) {
    double* const to_send = exchange.to_send();
    for (std::size_t i = 0; i < last_of_others().size(); ++i) {
      EXPECT_EQ(to_send[i], 0.);
      to_send[i] += factor * (this_rank + 1.);
    }
    exchange.begin_to_send();
    std::vector<double> own(3, 0.5);
    exchange.add_received(own.data());
    const double of_others = n_ranks * (n_ranks + 1.) / 2. - (this_rank + 1.);
    EXPECT_EQ(own, (std::vector<double>{0.5, 0.5, 0.5 + factor * of_others}));
  }
}

TEST_F(RanksWithThreeUnknowns, ReceiveAndSendInTurns) {
  const std::vector<double> values{1., 2., 3. + this_rank};
  exchange.begin_to_receive(values.data());
  exchange.end_of_receiving();
  for (std::size_t i = 0; i < last_of_others().size(); ++i) EXPECT_EQ(exchange.to_send()[i], 0.);
  exchange.begin_to_send();
  std::vector<double> own(3, 0.5);
  exchange.add_received(own.data());
  EXPECT_EQ(own, std::vector<double>(3, 0.5)) << "nothing of what was received is sent";
}

}  // namespace
}  // namespace geneva::fem::test
