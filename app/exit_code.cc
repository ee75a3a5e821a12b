#include "app/exit_code.h"

#include <deal.II/base/mpi.h>

#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

#include "base/errors.h"
#include "fem/contact_problem.h"

namespace geneva::app {

namespace {

int say(const ExitCode code, const std::string& text) {
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::cerr << "geneva: " << text << '\n';
  return code;
}

}  // namespace

int exit_code_of(const std::function<int()>& command) {
  try {
    return command();
  } catch (const std::invalid_argument& error) {
    return say(wrong_input, error.what());
  } catch (const fem::NotConverged& error) {
    return say(not_converged, error.what());
  } catch (const base::LimitReached& error) {
    return say(not_converged, error.what());
  } catch (const std::runtime_error& error) {
    return say(wrong_input, error.what());  // of the machine: a full disk, a missing unit database
  } catch (const std::exception& error) {
    return say(internal_error, std::string("internal error, please report it: ") + error.what());
  }
}

}  // namespace geneva::app
