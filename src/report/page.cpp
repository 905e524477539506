#include "report/page.hpp"
#include "report/resources.hpp"
#include <cmath>
#include <fmt/format.h>
#include <sstream>

namespace towform {

namespace {

using Grade = Finding::Grade;

const char* css_class(Grade grade)
{
  return grade == Grade::good ? "good" : grade == Grade::watch ? "watch" : "bad";
}

/// Said in a sign too: not everyone tells the colours apart.
const char* sign(Grade grade) { return grade == Grade::good ? "✓" : grade == Grade::watch ? "!" : "✕"; }

std::string badge(Grade grade, bool preview)
{
  if (preview) return "<span class=\"badge watch\">a preview: nothing is computed</span>";
  return fmt::format("<a class=\"badge {}\" href=\"#verdict\"><span aria-hidden=\"true\">{}</span> {}</a>",
                     css_class(grade), sign(grade),
                     grade == Grade::good    ? "nothing speaks against it"
                     : grade == Grade::watch ? "look at the verdict"
                                             : "do not trust it unseen");
}

std::string title_of(const PageContent& p)
{
  const std::string title = p.frames.text("title");
  return title.empty() ? "Untitled" : title;
}

/// One line of what was done to what.
std::string subtitle(const PageContent& p)
{
  const RunRecord& run = p.run;
  const double time = run.sheet.time;
  std::string text = fmt::format("{} elements, {:.4g} {}", run.sheet.flat.triangles.size(),
                                 time < 1.0 ? 1e3 * time : time, time < 1.0 ? "ms" : "s");
  if (!run.run_case) return text;
  const Case& c = *run.run_case;
  text += fmt::format(", {:.0f} °C", c.material.temperature - 273.15);
  if (!c.material.source.empty()) text += ", " + c.material.source.substr(0, c.material.source.find(','));
  if (c.blank.symmetry != Symmetry::none)
    text += c.blank.symmetry == Symmetry::quarter ? "; a quarter is modelled" : "; a half is modelled";
  return text;
}

std::string figure(double value, const char* format, const char* units, const char* label)
{
  if (!std::isfinite(value)) return "";
  return fmt::format("<li><b>{}<small>{}</small></b><span>{}</span></li>",
                     fmt::format(fmt::runtime(format), value), units, label);
}

std::string figures(const RunRecord& run)
{
  const double kinetic = run.figure("kinetic_to_internal_max");
  const auto part = [&](const char* group, const char* name) {
    const auto found = run.summary.find(group);
    return found != run.summary.end() ? found->value(name, std::nan("")) : std::nan("");
  };
  const std::string list =
      figure(run.figure("shear_angle_max_deg"), "{:.1f}", "°", "largest shear") +
      figure(run.figure("shear_angle_p99_deg"), "{:.1f}", "°", "99 % of elements below") +
      figure(part("draw_in_mm", "x_mid"), "{:.1f}", " mm", "draw-in along x") +
      figure(part("draw_in_mm", "y_mid"), "{:.1f}", " mm", "draw-in along y") +
      figure(run.figure("punch_force_max_N"), "{:.4g}", " N", "largest driving force") +
      figure(100.0 * run.figure("energy_error"), "{:.2g}", " %", "energy error") +
      figure(kinetic > 0.0 ? 100.0 * kinetic : NAN, kinetic < 0.1 ? "{:.2g}" : "{:.0f}", " %",
             "kinetic energy, second half") +
      figure(run.figure("penetration_max_mm"), "{:.2g}", " mm", "deepest penetration") +
      figure(100.0 * run.figure("fibre_strain_p99"), "{:.2g}", " %", "yarn strain, 99 %");
  return list.empty() || run.is_preview() ? "" : "<ul class=\"figures\">" + list + "</ul>\n";
}

std::string view(const PageContent& p)
{
  if (p.scene == nullptr)
    return "<section id=\"view\"><p class=\"absent\">This page has no 3-D view: this towform was built "
           "without "
           "Node, which bundles it (scripts/packages-viewer). <code>results.xdmf</code> opens in ParaView, "
           "and "
           "<code>tools/plot.py</code> draws pictures.</p></section>\n";
  return "<section id=\"view\"><div id=\"viewer\" class=\"viewer\"><p class=\"absent\">Loading the 3-D view; "
         "it "
         "needs JavaScript and WebGL.</p></div></section>\n";
}

std::string list_items(const std::vector<std::string>& items)
{
  std::string text;
  for (const std::string& item : items) text += fmt::format("<li>{}</li>", html(item));
  return text;
}

std::string verdict_section(const PageContent& p)
{
  std::string items;
  for (const Finding& f : p.findings)
    items += fmt::format("<li class=\"{}\"><span class=\"sign\" aria-hidden=\"true\">{}</span>{}</li>",
                         css_class(f.grade), sign(f.grade), html(f.text));
  std::string text = fmt::format("<section id=\"verdict\"><h2>Can it be believed?</h2>"
                                 "<ul class=\"findings\">{}</ul>",
                                 items);
  if (const auto warnings = warnings_of(p.run.log); !warnings.empty())
    text += fmt::format("<h3>The run warned</h3><ul class=\"plain\">{}</ul>", list_items(warnings));
  if (!p.notes.empty())
    text += fmt::format("<h3>Left out of this page</h3><ul class=\"plain\" id=\"notes\">{}</ul>",
                        list_items(p.notes));
  return text + "</section>\n";
}

std::string plots_section(const PageContent& p)
{
  if (p.run.is_preview()) return "";
  std::string text = "<section id=\"plots\"><h2>Curves</h2><div class=\"plots\">\n";
  for (const Plot& plot : p.plots) text += plot_html(plot);
  return text + "</div></section>\n";
}

std::string summary_table(const nlohmann::ordered_json& summary, const std::string& before = "")
{
  std::string rows;
  for (const auto& [name, value] : summary.items())
    rows += value.is_object()
                ? summary_table(value, before + name + ".")
                : fmt::format("<tr><th>{}</th><td>{}</td></tr>", html(before + name),
                              html(value.is_string() ? value.get<std::string>() : value.dump()));
  return rows;
}

std::string provenance(const PageContent& p)
{
  std::string rows;
  const auto row = [&](const char* name, const std::string& value) {
    if (!value.empty()) rows += fmt::format("<tr><th>{}</th><td>{}</td></tr>", name, html(value));
  };
  row("program", fmt::format("towform {} ({})", p.frames.text("version"), p.frames.text("git_hash")));
  row("built with", p.frames.text("flags"));
  row("status", p.frames.text("status"));
  std::istringstream inputs(p.frames.text("inputs"));
  for (std::string line; std::getline(inputs, line);)
    if (const std::size_t gap = line.find("  "); gap != std::string::npos)
      rows += fmt::format("<tr><th>{}</th><td><code>{}</code></td></tr>", html(line.substr(gap + 2)),
                          html(line.substr(0, gap)));
  return fmt::format("<table>{}</table>", rows);
}

std::string details(const char* id, const char* title, const std::string& inside)
{
  return fmt::format("<details id=\"{}\"><summary>{}</summary>{}</details>\n", id, title, inside);
}

std::string papers(const PageContent& p)
{
  std::string text = "<section id=\"papers\"><h2>Papers</h2>\n";
  if (!p.run.summary.empty())
    text += details("summary", "Figures of the run", "<table>" + summary_table(p.run.summary) + "</table>");
  if (!p.run.resolved_case.empty())
    text += details("case", "The case, with every default", "<pre>" + html(p.run.resolved_case) + "</pre>");
  if (const std::string given = p.frames.text("case"); !given.empty())
    text += details("case-given", "The case as it was written", "<pre>" + html(given) + "</pre>");
  if (!p.run.log.empty()) text += details("log", "What the run said", "<pre>" + html(p.run.log) + "</pre>");
  text += details("provenance", "Where it comes from: program and SHA-256 of every input", provenance(p));
  return text + "</section>\n";
}

/// The description as JSON that no HTML reader mistakes for a tag, then the blocks.
std::string data(const Scene& scene)
{
  std::string json = scene.description.dump();
  for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos; at += 6)
    json.replace(at, 1, "\\u003c");
  std::string text = fmt::format("<script type=\"application/json\" id=\"scene\">{}</script>\n", json);
  for (const SceneBlock& block : scene.blocks)
    text += fmt::format("<script type=\"text/plain\" id=\"block-{}\">{}</script>\n", block.id, block.text);
  return text;
}

constexpr const char* theme_script =
    "<script>(()=>{const root=document.documentElement,button=document.getElementById('theme');"
    "const dark=()=>(root.dataset.theme||(matchMedia('(prefers-color-scheme: "
    "dark)').matches?'dark':'light'))==='dark';"
    "const show=()=>{button.textContent=dark()?'Light':'Dark'};show();"
    "button.onclick=()=>{root.dataset.theme=dark()?'light':'dark';show();"
    "dispatchEvent(new Event('themechange'))}})()</script>\n";

} // namespace

std::string page_html(const PageContent& p)
{
  const std::string title = title_of(p);
  std::string page =
      fmt::format("<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
                  "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
                  "<meta name=\"generator\" content=\"towform {}\"><link rel=\"icon\" href=\"data:,\">"
                  "<title>{}</title>\n<style>\n{}</style></head>\n<body>\n",
                  html(p.frames.text("version")), html(title), resources::style());
  page += fmt::format(
      "<header><div><h1>{}</h1><p>{}</p></div>{}<button id=\"theme\" type=\"button\">Dark</button>"
      "</header>\n<main>\n",
      html(title), html(subtitle(p)), badge(worst(p.findings), p.run.is_preview()));
  page += figures(p.run);
  page += view(p) + verdict_section(p) + plots_section(p) + papers(p);
  page += "</main>\n";
  page += theme_script;
  if (p.scene != nullptr) {
    page += data(*p.scene);
    page += "<script>\n";
    page += resources::viewer();
    page += "</script>\n";
  }
  return page + "</body></html>\n";
}

} // namespace towform
