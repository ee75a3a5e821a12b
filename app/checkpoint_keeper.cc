#include "app/checkpoint_keeper.h"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "api/checkpoint_file.h"
#include "app/interruption.h"
#include "base/errors.h"
#include "base/output_file.h"

namespace geneva::app {

namespace fs = std::filesystem;

namespace {

/// Runs that take less are as quickly begun again.
constexpr double a_while = 60.;

}  // namespace

CheckpointKeeper::CheckpointKeeper(const model::Case& given, const fs::path& results,
                                   std::string last, std::string command)
    : mode_(given.checkpoints),
      is_in_space_(given.dimension == 3),
      file_(api::unfinished_checkpoint(results)),
      last_(std::move(last)),
      command_(std::move(command)) {}

bool CheckpointKeeper::is_wanted() const {
  return mode_ == model::Checkpoints::always ||
         (mode_ == model::Checkpoints::automatic && is_in_space_);
}

bool CheckpointKeeper::is_due(const double seconds) const {
  return mode_ == model::Checkpoints::always || (is_wanted() && seconds > a_while);
}

std::string CheckpointKeeper::keep(std::string text) {
  last_ = std::move(text);
  try {
    base::replace_own_file(file_, last_);
    say_if_interrupted(advice());
    return "";
  } catch (const base::InputError& error) {
    if (std::exchange(has_failed_, true)) return "";
    return fmt::format("this run could not be continued if it were ended: {}", error.what());
  }
}

void CheckpointKeeper::remove(const bool has_succeeded) const {
  if (!has_succeeded && last_.empty()) return;
  std::error_code ignored;
  fs::remove(file_, ignored);
}

std::string CheckpointKeeper::advice() const {
  return last_.empty() ? "" : fmt::format("'{}' goes on from the last mesh", command_);
}

std::string notice_of_unfinished(const fs::path& results, const std::string& command) {
  std::error_code ignored;
  if (!fs::exists(api::unfinished_checkpoint(results), ignored)) return "";
  return fmt::format(
      "an earlier run did not end; '{}' goes on from its last mesh, until this run has ended",
      command);
}

}  // namespace geneva::app
