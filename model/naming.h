#pragma once

#include <string>

#include "base/errors.h"
#include "fem/problem/stop.h"
#include "model/input/case_file.h"
#include "model/problem_message.h"
#include "model/stop_message.h"

namespace geneva::model {

/// Runs a task and puts the case file's name before what it says against the case, unless a file is
/// named already.
template <typename Task>
auto naming(const Case& given, const Task& task) {
  const auto named = [&](const std::string& text) {
    const bool names_a_file = text.find(given.directory.string()) != std::string::npos;
    return names_a_file ? text : given.text.file + ": " + text;
  };
  try {
    return task();
  } catch (const fem::ProblemError& error) {
    throw base::InputError(named(message_of(error)));
  } catch (const base::InputError& error) {
    throw base::InputError(named(error.what()));
  } catch (const base::LimitReached& error) {
    throw base::LimitReached(named(error.what()));
  } catch (const fem::NotConverged& error) {
    throw base::LimitReached(named(message_of(error.stop)));
  }
}

}  // namespace geneva::model
