#include "key_value.hpp"
#include "suggestion.hpp"
#include "towform/case.hpp"
#include <array>
#include <fmt/format.h>

namespace towform {

std::string key_reference()
{
  std::string text =
      "# Keys of a case\n\n"
      "A number is in SI units; text has a number and a unit, \"650 mm\". Numbers without a\n"
      "dimension may also be given in per cent, \"30 %\". Any key can be set on the command line:\n"
      "`--set blank.thickness=2mm`, a tool's or boundary's by its name: `--set tool.punch.friction=0.1`.\n\n"
      "| dimension | units |\n|---|---|\n";
  for (int d = static_cast<int>(Dimension::length); d <= static_cast<int>(Dimension::frequency); ++d) {
    const auto dimension = static_cast<Dimension>(d);
    text += fmt::format("| {} | {} |\n", dimension_name(dimension), listed(units_of(dimension)));
  }
  std::string last;
  text += "\n| key | type | default | range | meaning |\n|---|---|---|---|---|\n";
  for (const Row& row : key_table()) {
    if (row.section() != last) {
      last = row.section();
      text += fmt::format("\n## {}\n\n| key | type | default | range | meaning |\n|---|---|---|---|---|\n",
                          is_list_section(last) ? "[[" + last + "]]" : "[" + last + "]");
    }
    text += fmt::format("| `{}` | {} | {} | {} | {} |\n", row.path, type_of(row), row.default_text, row.range,
                        row.meaning);
  }
  return text;
}

} // namespace towform
