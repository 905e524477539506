#include "completion.hpp"
#include "case/key_table.hpp"
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace towform {

std::vector<const CLI::App*> commands_of(const CLI::App& app)
{
  return app.get_subcommands([](const CLI::App*) { return true; });
}

namespace {

std::vector<std::string> words_of(const CLI::App& app)
{
  std::vector<std::string> words;
  for (const CLI::App* inner : commands_of(app)) words.push_back(inner->get_name());
  for (const CLI::Option* option : app.get_options())
    if (!option->get_positional())
      for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
  return words;
}

/// One line of the case statement for each command and command of a command.
void completion_lines(const CLI::App& app, const std::string& before, std::string& lines)
{
  lines += fmt::format("    '{}') words='{}' ;;\n", before, fmt::join(words_of(app), " "));
  for (const CLI::App* inner : commands_of(app))
    completion_lines(*inner, before.empty() ? inner->get_name() : before + " " + inner->get_name(), lines);
}

/// Text between single quotes of a shell.
std::string quoted(const std::string& text)
{
  std::string safe = "'";
  for (const char c : text) safe += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return safe + "'";
}

/// A word with what it means, as zsh's _describe takes it.
std::string described(const std::string& word, const std::string& meaning)
{
  return quoted(word + ':' + meaning.substr(0, meaning.find('\n')));
}

/// As completion_lines, with meanings.
void zsh_lines(const CLI::App& app, const std::string& before, std::string& lines)
{
  std::string commands, options;
  for (const CLI::App* inner : commands_of(app))
    commands += " " + described(inner->get_name(), inner->get_description());
  for (const CLI::Option* option : app.get_options())
    if (!option->get_positional())
      for (const std::string& name : option->get_lnames())
        options += " " + described("--" + name, option->get_description());
  lines += fmt::format("    {}) commands=({}) options=({}) ;;\n", quoted(before), commands, options);
  for (const CLI::App* inner : commands_of(app))
    zsh_lines(*inner, before.empty() ? inner->get_name() : before + " " + inner->get_name(), lines);
}

} // namespace

std::string bash_completion(const CLI::App& app)
{
  std::string lines, keys;
  completion_lines(app, "", lines);
  for (const Row& row : key_table())
    if (!is_list_section(row.section())) keys += row.path + "= ";
  return fmt::format(R"(# Written by `towform completion bash`.
_towform() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} command='' words='' i
  if [ "$previous" = --set ]; then
    compopt -o nospace
    COMPREPLY=($(compgen -W '{}' -- "$current"))
    return
  fi
  for ((i = 1; i < COMP_CWORD; i++)); do
    case "${{COMP_WORDS[i]}}" in -*) ;; *) case "$command ${{COMP_WORDS[i]}}" in
      ' '*|'material '*|'mesh '*|'completion '*) command="${{command:+$command }}${{COMP_WORDS[i]}}" ;; esac ;; esac
  done
  case "$command" in
{}  esac
  case "$current" in
    -*) COMPREPLY=($(compgen -W "$words" -- "$current")) ;;
    *) COMPREPLY=($(compgen -W "${{words//--*/}}" -- "$current") $(compgen -f -- "$current")) ;;
  esac
}}
complete -o filenames -F _towform towform
)",
                     keys, lines);
}

std::string zsh_completion(const CLI::App& app)
{
  std::string lines, keys;
  zsh_lines(app, "", lines);
  for (const Row& row : key_table())
    if (!is_list_section(row.section())) keys += "    " + described(row.path, row.meaning) + '\n';
  return fmt::format(R"(#compdef towform
# Written by `towform completion zsh`.
_towform() {{
  local command='' word
  local -a commands options keys
  if [[ $words[CURRENT-1] == --set ]]; then
    keys=(
{}    )
    _describe -t keys 'key of the case' keys -S '='
    return
  fi
  for word in $words[2,CURRENT-1]; do
    case "$word" in -*) ;; *) case "$command $word" in
      ' '*|'material '*|'mesh '*|'completion '*) command="${{command:+$command }}$word" ;; esac ;; esac
  done
  case "$command" in
{}  esac
  if [[ $PREFIX == -* ]]; then
    _describe -o -t options option options
  else
    (( $#commands )) && _describe -t commands command commands
    _files
  fi
}}
if [[ $funcstack[1] == _towform ]]; then _towform "$@"; else compdef _towform towform; fi
)",
                     keys, lines);
}

} // namespace towform
