#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/command_line.h"

namespace geneva::app {

/// The words of the command line, and the request that reading them fills. Help, manual pages and
/// completions are made from it.
class Grammar {
 public:
  Grammar();
  Grammar(const Grammar&) = delete;
  Grammar& operator=(const Grammar&) = delete;

  [[nodiscard]] CLI::App& app() { return app_; }
  /// The request, after app().parse().
  /// @throws CLI::ValidationError if options contradict each other
  [[nodiscard]] Request request() const;

 private:
  CLI::App* add(Request::Command command, const std::string& name, const std::string& help);
  void add_analyses();
  void add_design();
  void add_documents();
  void add_helpers();

  CLI::App app_;
  Request request_;
  std::string case_directory_ = ".";
  std::vector<std::string> several_;  ///< cases or results
  std::string output_;
  bool is_crown_ = false;
  bool has_strength_ = false;
  bool is_unconfirmed_ = false;
  std::vector<std::pair<CLI::App*, Request::Command>> commands_;
};

/// A command of the program; nothing if there is none of that name.
CLI::App* command_named(CLI::App& app, const std::string& name);

/// Text within single quotes of a shell.
std::string shell_quoted(const std::string& text);

/// Manual page of a command, or of the program, as a text for man(1).
std::string manual_page(const CLI::App& command);

/// Completion of commands, options and directories.
/// @param shell "bash", "zsh" or "fish"
std::string completion(const CLI::App& app, const std::string& shell);

}  // namespace geneva::app
