#pragma once

#include <filesystem>
#include <string>

#include "model/input/case_file.h"

namespace geneva::app {

/// Keeps the last checkpoint of a run beside its results directory until the run has ended.
class CheckpointKeeper {
 public:
  /// @param last that of the run which this one continues; may be empty
  /// @param command that would continue the run: "geneva run --continue CASE"
  CheckpointKeeper(const model::Case& given, const std::filesystem::path& results, std::string last,
                   std::string command);

  /// Whether the run may want one at all.
  [[nodiscard]] bool is_wanted() const;
  /// Whether a mesh that is finished after so many seconds leaves one.
  [[nodiscard]] bool is_due(double seconds) const;
  /// @return what to tell the user, once, if the file cannot be written: the run can go on
  std::string keep(std::string text);
  /// The last one; may be empty.
  [[nodiscard]] const std::string& last() const { return last_; }
  /// Removes that beside the results, unless it is an earlier run's, which came further than one
  /// that has not succeeded and left none.
  void remove(bool has_succeeded) const;
  /// How to continue the run; empty if there is no checkpoint.
  [[nodiscard]] std::string advice() const;

 private:
  model::Checkpoints mode_;
  bool is_in_space_;
  std::filesystem::path file_;
  std::string last_;
  std::string command_;
  bool has_failed_ = false;
};

/// A note on what an earlier run left, which this one does not continue; empty if it left nothing.
std::string notice_of_unfinished(const std::filesystem::path& results, const std::string& command);

}  // namespace geneva::app
