#include <fmt/format.h>

#include <algorithm>

#include "api/version.h"
#include "app/grammar.h"

namespace geneva::app {

namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<const CLI::Option*> options_of(const CLI::App& app, const bool is_positional) {
  std::vector<const CLI::Option*> options;
  for (const CLI::Option* option : app.get_options())
    if (option->get_positional() == is_positional) options.push_back(option);
  return options;
}

/// "--output", "-o": all names of an option.
std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

/// Text in which man(1) sees no markup.
std::string plain(const std::string& text) {
  // At the start of a line a point or an apostrophe would begin a request.
  std::string result = text.find_first_of(".'") == 0 ? "\\&" : "";
  for (const char letter : text) {
    if (letter == '\\' || letter == '-') result += '\\';
    result += letter;
  }
  return result;
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  return fmt::format("{}", fmt::join(words, between));
}

/// Name of a page: "geneva-run".
std::string page_name(const CLI::App& command) {
  return command.get_parent() == nullptr ? command.get_name() : "geneva-" + command.get_name();
}

std::string synopsis(const CLI::App& command) {
  std::string text = command.get_parent() == nullptr
                         ? "\\fBgeneva\\fR \\fICOMMAND\\fR"
                         : fmt::format("\\fBgeneva {}\\fR", plain(command.get_name()));
  text += " [\\fIOPTIONS\\fR]";
  for (const CLI::Option* argument : options_of(command, true))
    text +=
        fmt::format(argument->get_required() ? " \\fI{}\\fR{}" : " [\\fI{}\\fR{}]",
                    plain(argument->get_name(true)), argument->get_expected_max() > 1 ? "..." : "");
  return text + "\n";
}

std::string manual_options(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* argument : options_of(command, true))
    text += fmt::format(".TP\n\\fI{}\\fR\n{}\n", plain(argument->get_name(true)),
                        plain(argument->get_description()));
  for (const CLI::Option* option : options_of(command, false)) {
    const std::string value =
        option->get_expected_max() > 0 ? " \\fI" + plain(option->get_type_name()) + "\\fR" : "";
    text += fmt::format(".TP\n\\fB{}\\fR{}\n{}\n", plain(joined(names_of(*option), ", ")), value,
                        plain(option->get_description()));
  }
  return text;
}

std::string bash_completion(const CLI::App& app) {
  std::vector<std::string> names;
  std::string cases;
  for (const CLI::App* command : commands_of(app)) {
    names.push_back(command->get_name());
    std::vector<std::string> words;
    for (const CLI::Option* option : options_of(*command, false))
      for (const std::string& name : names_of(*option)) words.push_back(name);
    cases += fmt::format("    {}) words=\"{}\" ;;\n", command->get_name(), joined(words, " "));
  }
  return fmt::format(R"(_geneva() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} words=
  local commands="{0}"
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W "$commands --help --version" -- "$current"))
    return
  fi
  case ${{COMP_WORDS[1]}} in
{1}  esac
  case $previous in
    help | man) words=$commands ;;
    completion) words="bash zsh fish" ;;
    --type) words="external internal spherical long-dwell four-bar geometry" ;;
    --units) words="SI mm-N in-lbf" ;;
    *) [[ $current == -* ]] || {{ COMPREPLY=($(compgen -d -- "$current")); return; }} ;;
  esac
  COMPREPLY=($(compgen -W "$words" -- "$current"))
}}
complete -o filenames -F _geneva geneva
)",
                     joined(names, " "), cases);
}

/// Text within single quotes of a shell.
std::string shell_quoted(const std::string& text) {
  std::string result;
  for (const char letter : text)
    result += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return "'" + result + "'";
}

/// Text that _arguments and _describe take for no markup.
std::string zsh_text(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    if (letter == ':' || letter == '[' || letter == ']') result += '\\';
    result += letter;
  }
  return result;
}

std::string zsh_completion(const CLI::App& app) {
  std::string commands;
  std::string cases;
  for (const CLI::App* command : commands_of(app)) {
    commands += "    " +
                shell_quoted(command->get_name() + ":" + zsh_text(command->get_description())) +
                "\n";
    cases += fmt::format("    {}) _arguments", command->get_name());
    for (const CLI::Option* option : options_of(*command, false))
      for (const std::string& name : names_of(*option))
        cases +=
            " " + shell_quoted(fmt::format("{}[{}]{}", name, zsh_text(option->get_description()),
                                           option->get_expected_max() > 0 ? ":value:_files" : ""));
    cases += " '*:directory:_files -/' ;;\n";
  }
  return fmt::format(R"(#compdef geneva
_geneva() {{
  local -a commands=(
{})
  if (( CURRENT == 2 )); then
    _describe command commands
    return
  fi
  local command=$words[2]
  shift words
  (( CURRENT-- ))
  case $command in
{}  esac
}}
_geneva "$@"
)",
                     commands, cases);
}

std::string fish_completion(const CLI::App& app) {
  std::string text =
      "complete -c geneva -f -n __fish_use_subcommand -s h -l help -d 'Print help'\n";
  for (const CLI::App* command : commands_of(app)) {
    const std::string seen = shell_quoted("__fish_seen_subcommand_from " + command->get_name());
    text += fmt::format("complete -c geneva -f -n __fish_use_subcommand -a {} -d {}\n",
                        command->get_name(), shell_quoted(command->get_description()));
    for (const CLI::Option* option : options_of(*command, false)) {
      text += "complete -c geneva -n " + seen;
      for (const std::string& name : option->get_snames()) text += " -s " + name;
      for (const std::string& name : option->get_lnames()) text += " -l " + name;
      text += option->get_expected_max() > 0 ? " -r" : "";
      text += " -d " + shell_quoted(option->get_description()) + "\n";
    }
  }
  return text;
}

}  // namespace

std::string manual_page(const CLI::App& command) {
  const bool is_program = command.get_parent() == nullptr;
  std::string name = page_name(command);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](const unsigned char c) { return static_cast<char>(std::toupper(c)); });
  std::string text = fmt::format(".TH {} 1 \"\" \"geneva {}\" \"User commands\"\n", name, version);
  text += fmt::format(".SH NAME\n{} \\- {}\n", plain(page_name(command)),
                      plain(command.get_description()));
  text += ".SH SYNOPSIS\n" + synopsis(command);
  if (is_program) {
    text += ".SH COMMANDS\n";
    for (const CLI::App* each : commands_of(command))
      text += fmt::format(".TP\n\\fB{}\\fR\n{}\n", plain(each->get_name()),
                          plain(each->get_description()));
  }
  text += ".SH OPTIONS\n" + manual_options(command);
  if (is_program) text += ".SH EXAMPLES\n.nf\n" + plain(command.get_footer()) + "\n.fi\n";
  text +=
      ".SH EXIT STATUS\n0: done; a safety factor below 1 does not change that (summary.json "
      "tells them). 1: wrong input. 2: a limit of the run was reached before the accuracy that is "
      "wanted. 3: an error of the program.\n.SH SEE ALSO\n";
  return text + (is_program ? "\\fBgeneva\\-run\\fR(1), \\fBgeneva\\-init\\fR(1)\n"
                            : "\\fBgeneva\\fR(1)\n");
}

std::string completion(const CLI::App& app, const std::string& shell) {
  if (shell == "bash") return bash_completion(app);
  return shell == "zsh" ? zsh_completion(app) : fish_completion(app);
}

}  // namespace geneva::app
