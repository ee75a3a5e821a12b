#include "app/command_line.h"

#include <fmt/format.h>

#include <iostream>

#include "api/version.h"
#include "app/grammar.h"
#include "app/highlight.h"
#include "base/units.h"
#include "model/input/nearest_word.h"

namespace geneva::app {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

/// What is said of a word that is no command.
std::string refusal_of(const std::string& word, const CLI::App& app) {
  std::error_code error;
  std::string meant;
  if (const auto nearest = model::nearest_word(word, command_names(app)))
    meant = fmt::format(": did you mean 'geneva {}'?", *nearest);
  else if (fs::exists(fs::path(word) / "case.prm", error))
    meant = fmt::format(": did you mean 'geneva run {}'?", word);
  return fmt::format("geneva: {} is no command{}\n'geneva help' lists the commands\n",
                     base::in_quotes(word), meant);
}

int print_help(CLI::App& app, const std::string& topic) {
  if (topic.empty()) {
    std::cout << app.help();
    return 0;
  }
  const CLI::App* command = command_named(app, topic);
  if (command == nullptr) {
    std::cerr << for_stream(refusal_of(topic, app), stderr);
    return 1;
  }
  std::cout << command->help(app.get_name());
  return 0;
}

int print_manual(CLI::App& app, const std::string& topic) {
  const CLI::App* command = topic.empty() ? &app : command_named(app, topic);
  if (command == nullptr) {
    std::cerr << for_stream(refusal_of(topic, app), stderr);
    return 1;
  }
  std::cout << manual_page(*command);
  return 0;
}

/// Obeys what concerns the command line alone; the rest goes on as a request.
std::variant<Request, int> answer(const Request& request) {
  Grammar unread;  // one that has read a command tells of that command only
  CLI::App& app = unread.app();
  switch (request.command) {
    case Request::Command::help:
      return print_help(app, request.topic);
    case Request::Command::version:
      std::cout << version << '\n';
      return 0;
    case Request::Command::manual:
      return print_manual(app, request.topic);
    case Request::Command::completion:
      std::cout << completion(app, request.topic);
      return 0;
    default:
      return request;
  }
}

void complain(const std::string& about, const std::string& command) {
  std::cerr << for_stream(
      fmt::format("geneva: {}; 'geneva help {}' lists the options\n", about, command), stderr);
}

}  // namespace

std::variant<Request, int> read_command_line(const int argc, const char* const* argv) {
  Grammar grammar;
  CLI::App& app = grammar.app();
  if (argc < 2) return print_help(app, "");
  const std::string first = argv[1];
  if (!first.empty() && first.front() != '-' && command_named(app, first) == nullptr) {
    std::cerr << for_stream(refusal_of(first, app), stderr);
    return 1;
  }
  try {
    app.parse(argc, argv);
    return answer(grammar.request());
  } catch (const CLI::ExtrasError&) {
    complain(fmt::format("not expected here: {}", fmt::join(app.remaining(true), " ")), first);
    return 1;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    complain(error.what(), first);
    return 1;
  }
}

}  // namespace geneva::app
