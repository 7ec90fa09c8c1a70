#include "html_page.h"

#include <fmt/format.h>

#include <algorithm>

namespace rt::cli {
namespace {

constexpr std::string_view style = R"(
body { font: 15px/1.45 sans-serif; color: #222; background: #fff; margin: 2em auto; max-width: 75em; padding: 0 1em }
h1, h2 { font-weight: 600 } h3 { margin-bottom: .3em }
.pictures { display: flex; flex-wrap: wrap; gap: 1em }
figure { margin: 0 } img { max-width: 100%; height: auto; image-rendering: pixelated; border: 1px solid #ccc }
figcaption { color: #555; font-size: 13px; max-width: 40em }
table { border-collapse: collapse } td { padding: .15em .9em .15em 0; vertical-align: top }
td.bar { width: 24em } td.bar div { background: #0072b2; height: .8em }
td.number { text-align: right; font-variant-numeric: tabular-nums }
)";

}  // namespace

std::string html_escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string html_table(const std::vector<std::pair<std::string, std::string>>& rows) {
  std::string out = "<table>\n";
  for (const auto& [name, value] : rows) {
    out +=
        fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", html_escaped(name), html_escaped(value));
  }
  return out + "</table>\n";
}

std::string phases_table(const Phases& phases) {
  const std::pair<const char*, double> rows[] = {
      {"script", phases.script},
      {"compiling the scene, building what finds hits", phases.plan},
      {"tracing", phases.trace},
      {"writing the picture, loading of OpenImageIO included", phases.write}};
  double most = 0.0;
  for (const auto& row : rows) {
    most = std::max(most, row.second);
  }
  std::string out = "<table>\n";
  for (const auto& [name, seconds] : rows) {
    out += fmt::format(
        "<tr><td>{}</td><td class=\"number\">{:.4f} s</td>"
        "<td class=\"bar\"><div style=\"width:{:.1f}%\"></div></td></tr>\n",
        name, seconds, most > 0.0 ? 100.0 * seconds / most : 0.0);
  }
  return out +
         fmt::format("</table>\n<p>Processor time of the threads that traced: {:.4f} s.</p>\n",
                     phases.trace_cpu);
}

std::string rays_table(const RenderStatistics& statistics) {
  const RayCounts& rays = statistics.rays;
  return html_table({{"camera", std::to_string(rays.camera)},
                     {"shadow", std::to_string(rays.shadow)},
                     {"reflection", std::to_string(rays.reflection)},
                     {"refraction", std::to_string(rays.refraction)},
                     {"samples", std::to_string(statistics.samples)},
                     {"samples that were not finite", std::to_string(statistics.bad_samples)}});
}

std::string html_page(const std::string& scene, const std::string& body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n"
      "<p>raytracer {2}</p>\n{3}</body>\n</html>\n",
      html_escaped(scene), style, RT_VERSION, body);
}

}  // namespace rt::cli
