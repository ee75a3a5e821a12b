#include "app/exit_code.h"

#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>

#include "api/version.h"
#include "app/highlight.h"
#include "base/errors.h"
#include "base/printable.h"
#include "fem/problem/stop.h"
#include "model/stop_message.h"

namespace geneva::app {

std::string bug_report(const std::string& what, const std::string& about) {
  return fmt::format(
      "internal error in geneva {} ({}): {}\nThis is a mistake in the program: please report it to "
      "its maintainers (CITATION.cff) with this text and the case directory.",
      version, about, what);
}

void say_failure(const int /*code*/, const std::string& text) {
  std::cout.flush();
  std::cerr << for_stream("geneva: " + base::without_controls(text), stderr) + "\n";
}

int exit_code_of(const std::function<int()>& command, const std::string& about,
                 const std::function<void(int, const std::string&)>& fail) {
  const auto failed = [&](const ExitCode code, const std::string& text) {
    fail(code, text);
    return code;
  };
  try {
    return command();
  } catch (const base::InputError& error) {
    return failed(wrong_input, error.what());
  } catch (const fem::NotConverged& error) {
    return failed(not_converged, model::message_of(error.stop));
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

int exit_code_at_start() {
  const auto failed = [](const ExitCode code, const std::string& text) {
    say_failure(code, text);
    return code;
  };
  try {
    throw;
  } catch (const base::InputError& error) {
    return failed(wrong_input, error.what());
  } catch (const std::bad_alloc&) {
    return failed(not_converged, "memory ran out while the program started");
  } catch (const std::exception& error) {
    return failed(internal_error, std::string("cannot start: ") + error.what());
  } catch (...) {
    return failed(internal_error, "cannot start: unknown exception");
  }
}

}  // namespace geneva::app
