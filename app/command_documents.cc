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
  std::string result;
  char before = '\n';
  for (const char letter : text) {
    // At the start of a line a point or an apostrophe would begin a request.
    if (before == '\n' && (letter == '.' || letter == '\'')) result += "\\&";
    before = letter;
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

/// Words that an option takes; empty where any text may follow.
std::string values_of(const std::string& option) {
  if (option == "--type") return "external internal spherical long-dwell four-bar geometry";
  if (option == "--units") return "SI mm-N in-lbf";
  if (option == "--with") return "run estimate kinematics design";
  return "";
}

std::vector<std::string> names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : commands_of(app)) names.push_back(command->get_name());
  return names;
}

/// Words that a command's argument is one of; empty where it is a directory.
std::string arguments_of(const CLI::App& command) {
  const std::string name = command.get_name();
  if (name == "completion") return "bash zsh fish";
  return name == "help" || name == "man" ? joined(names_of_commands(*command.get_parent()), " ")
                                         : "";
}

std::string bash_completion(const CLI::App& app) {
  const std::vector<std::string> names = names_of_commands(app);
  std::string cases;
  for (const CLI::App* command : commands_of(app)) {
    std::vector<std::string> words;
    for (const CLI::Option* option : options_of(*command, false))
      for (const std::string& name : names_of(*option)) words.push_back(name);
    cases += fmt::format("    {}) options=\"{}\" arguments=\"{}\" ;;\n", command->get_name(),
                         joined(words, " "), arguments_of(*command));
  }
  std::string values;
  for (const char* const option : {"--type", "--units", "--with"})
    values += fmt::format("    {}) words=\"{}\" ;;\n", option, values_of(option));
  return fmt::format(R"(_geneva() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} options= arguments= words=
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W "{0} --help --version" -- "$current"))
    return
  fi
  case ${{COMP_WORDS[1]}} in
{1}  esac
  words=$arguments
  [[ $current == -* ]] && words=$options
  case $previous in
{2}  esac
  # Without words the shell itself completes directories, with blanks and tildes.
  COMPREPLY=()
  [ -z "$words" ] || COMPREPLY=($(compgen -W "$words" -- "$current"))
}}
complete -o dirnames -F _geneva geneva
)",
                     joined(names, " "), cases, values);
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

/// What follows an option, as _arguments wants it.
std::string zsh_value(const CLI::Option& option) {
  if (option.get_expected_max() == 0) return "";
  const std::string words = values_of(names_of(option).back());
  return words.empty() ? ":value:_files" : ":value:(" + words + ")";
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
                                           zsh_value(*option)));
    const std::string words = arguments_of(*command);
    cases += words.empty() ? " '*:directory:_files -/' ;;\n" : " '*:word:(" + words + ")' ;;\n";
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
    if (const std::string words = arguments_of(*command); !words.empty())
      text += fmt::format("complete -c geneva -f -n {} -a {}\n", seen, shell_quoted(words));
    for (const CLI::Option* option : options_of(*command, false)) {
      text += "complete -c geneva -n " + seen;
      for (const std::string& name : option->get_snames()) text += " -s " + name;
      for (const std::string& name : option->get_lnames()) text += " -l " + name;
      if (const std::string words = values_of(names_of(*option).back()); !words.empty())
        text += " -x -a " + shell_quoted(words);
      else if (option->get_expected_max() > 0)
        text += " -r";
      text += " -d " + shell_quoted(option->get_description()) + "\n";
    }
  }
  return text;
}

}  // namespace

std::string shell_quoted(const std::string& text) {
  std::string result;
  for (const char letter : text)
    result += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return "'" + result + "'";
}

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
  const std::string footer = command.get_footer();
  if (is_program)
    text += ".SH EXAMPLES\n.nf\n" + plain(footer.substr(footer.find('\n') + 1)) + "\n.fi\n";
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
