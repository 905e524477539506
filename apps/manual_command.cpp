#include "manual_command.hpp"
#include "case/key_value.hpp"
#include "completion.hpp"
#include "towform/case_schema.hpp"
#include "version.hpp"
#include <fmt/format.h>

namespace towform {

namespace {

/// Text safe in a man page.
std::string roff(const std::string& text)
{
  std::string safe;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\\')
      safe += "\\e";
    else if (c == '-')
      safe += "\\-";
    else if ((c == '.' || c == '\'') && (i == 0 || text[i - 1] == '\n'))
      safe += std::string("\\&") + c;
    else
      safe += c;
  }
  return safe;
}

std::string option_line(const CLI::Option& option)
{
  std::string names = option.get_positional() ? option.get_type_name() : option.get_name(false, true);
  const std::string type = option.get_type_name();
  if (!option.get_positional() && option.get_expected_max() > 0 && !type.empty())
    names += " " + type.substr(0, type.find(':')); // without the check of its range
  return fmt::format(".TP\n.B {}\n{}\n", roff(names), roff(option.get_description()));
}

std::string command_text(const CLI::App& app, const std::string& before)
{
  const std::string name = before + " " + app.get_name();
  std::string text = fmt::format(".SS {}\n{}\n", roff(name), roff(app.get_description()));
  for (const CLI::Option* option : app.get_options())
    if (option->get_name() != "--help") text += option_line(*option);
  if (!app.get_footer().empty()) text += ".PP\n.nf\n" + roff(app.get_footer()) + "\n.fi\n";
  for (const CLI::App* inner : commands_of(app)) text += command_text(*inner, name);
  return text;
}

std::string keys_text()
{
  std::string text, last = "-";
  for (const Row& row : key_table()) {
    if (row.section() != last) {
      last = row.section();
      text += fmt::format(".SS {}\n", last.empty()            ? "outside any table"
                                      : is_list_section(last) ? "[[" + last + "]]"
                                                              : "[" + last + "]");
    }
    text += fmt::format(".TP\n.B {}\n{} ({}", roff(row.path), roff(row.meaning), roff(type_of(row)));
    if (!row.range.empty()) text += "; " + roff(row.range);
    if (row.default_text == required)
      text += "; required";
    else if (row.default_text != optional)
      text += "; default " + roff(row.default_text);
    text += ")\n";
  }
  return text;
}

std::string man_page(const CLI::App& app)
{
  std::string text =
      fmt::format(".\\\" Written by `towform manual`.\n.TH TOWFORM 1 \"\" \"towform {}\"\n.SH NAME\n"
                  "towform \\- forming simulation of woven composite sheets\n.SH SYNOPSIS\n"
                  ".B towform\n.I COMMAND\n[...]\n.SH DESCRIPTION\n{}.\nA case is a TOML file; "
                  "numbers are SI, text takes a unit.\n.SH COMMANDS\n",
                  version::number, roff(app.get_description()));
  for (const CLI::App* command : commands_of(app)) text += command_text(*command, "towform");
  text += ".SH KEYS OF A CASE\n" + keys_text();
  text += ".SH EXIT STATUS\n";
  for (const auto& [code, meaning] : {std::pair{0, "done"},
                                      {2, "usage"},
                                      {3, "case file"},
                                      {4, "files"},
                                      {5, "stopped by a stability or energy gate"},
                                      {6, "stopped by the contact gate"},
                                      {7, "checkpoint that cannot be gone on from"},
                                      {8, "comparison out of tolerance"},
                                      {70, "a bug in towform"},
                                      {75, "interrupted, with a checkpoint"}})
    text += fmt::format(".TP\n.B {}\n{}\n", code, meaning);
  return text + ".SH ENVIRONMENT\n.TP\n.B NO_COLOR\nset to anything: no colour on the terminal\n";
}

} // namespace

void add_manual_commands(CLI::App& app)
{
  const CLI::App* all = &app;
  app.add_subcommand("manual", "print the man page")->callback([all] { fmt::print("{}", man_page(*all)); });
  app.add_subcommand("schema", "print the JSON Schema of a case, for editors")->callback([] {
    fmt::print("{}", case_schema());
  });
  CLI::App* completion = app.add_subcommand("completion", "print completion for a shell");
  completion->require_subcommand(1);
  completion->add_subcommand("bash", "for bash: source <(towform completion bash)")->callback([all] {
    fmt::print("{}", bash_completion(*all));
  });
  completion->add_subcommand("zsh", "for zsh: source <(towform completion zsh), after compinit")
      ->callback([all] { fmt::print("{}", zsh_completion(*all)); });
}

} // namespace towform
