#include "app/exit_code.h"

#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <new>
#include <string>

#include "app/version.h"
#include "base/errors.h"
#include "fem/contact_problem.h"

namespace geneva::app {

std::string bug_report(const std::string& what, const std::string& about) {
  return fmt::format(
      "internal error in geneva {} ({}): {}\nThis is a mistake in the program: please report it to "
      "its maintainers (CITATION.cff) with this text and the case directory.",
      version, about, what);
}

int exit_code_of(const std::function<int()>& command, const std::string& about, Ending& ending) {
  const auto failed = [&](const ExitCode code, const std::string& text) {
    ending.fail(code, text);
    return code;
  };
  try {
    return command();
  } catch (const base::InputError& error) {
    return failed(wrong_input, error.what());
  } catch (const fem::NotConverged& error) {
    return failed(not_converged, error.what());
  } catch (const base::LimitReached& error) {
    return failed(not_converged, error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    return failed(wrong_input, error.what());  // of the machine: a directory that is no more
  } catch (const std::bad_alloc&) {
    return failed(not_converged, fmt::format("memory ran out ({})", about));
  } catch (const std::exception& error) {
    return failed(internal_error, bug_report(error.what(), about));
  } catch (...) {
    return failed(internal_error, bug_report("unknown exception", about));
  }
}

}  // namespace geneva::app
