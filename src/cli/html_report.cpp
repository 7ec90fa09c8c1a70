#include "rt/cli/html_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "html_page.h"
#include "rt/io/image.h"
#include "rt/io/whole_file.h"

namespace rt::cli {
namespace {

Rgb mixed(const Rgb& a, const Rgb& b, double t) { return a + std::clamp(t, 0.0, 1.0) * (b - a); }

std::string picture_tag(const io::Image& image, Encoding encoding, std::string_view caption) {
  const std::vector<unsigned char> png = io::encode_png(image, encoding);
  return fmt::format(
      "<figure><img alt=\"{0}\" width=\"{1}\" height=\"{2}\" src=\"data:image/png;base64,{3}\">"
      "<figcaption>{0}</figcaption></figure>\n",
      caption, image.width, image.height, base64(png));
}

/// A map of one number a pixel.
template <class T, class Colour>
io::Image map_of(const Film& film, const std::vector<T>& values, const Colour& colour) {
  io::Image map{film.width, film.height, {}};
  map.pixels.reserve(3 * values.size());
  for (const T value : values) {
    const Rgb c = colour(static_cast<double>(value));
    for (int k = 0; k < 3; ++k) {
      map.pixels.push_back(static_cast<float>(c[k]));
    }
  }
  return map;
}

std::string maps(const RenderOptions& options, const RenderResult& result) {
  if (!result.reached) {
    return "<p>Every pixel took the same samples, or as many as the classic scheme said: no error "
           "was estimated, so there are no maps. Leave out --samples and --aa to have them.</p>\n";
  }
  const double target = options.max_error;
  const auto [least, most] = std::minmax_element(result.samples.begin(), result.samples.end());
  const double fewest = *least;
  const double greatest = *most;
  return picture_tag(
             map_of(result.film, result.errors, [&](double e) { return error_colour(e, target); }),
             Encoding::raw,
             fmt::format("Estimated error, displayed units: white at {:g}, blue below to "
                         "{:.2g}, red above to {:.2g}",
                         target, target / 16, target * 16)) +
         picture_tag(map_of(result.film, result.samples,
                            [&](double n) { return count_colour(n, fewest, greatest); }),
                     Encoding::raw,
                     fmt::format("Samples: from {:.0f} (dark) to {:.0f} (light), by logarithm",
                                 fewest, greatest));
}

std::string options_table(const RenderOptions& options) {
  std::vector<std::pair<std::string, std::string>> rows;
  for (const OptionSpec& spec : option_specs()) {
    std::visit([&](const auto& v) { rows.emplace_back(spec.name, fmt::format("{}", v)); },
               spec.get(options));
  }
  return html_table(rows);
}

}  // namespace

Rgb error_colour(double error, double target) {
  constexpr double octaves = 4.0;
  const double at = std::log2(error / target) / octaves;  // of no error: -infinity, the bluest
  const Rgb white(0.97, 0.97, 0.97);
  return at < 0.0 ? mixed(white, Rgb(0.02, 0.27, 0.52), -at)
                  : mixed(white, Rgb(0.72, 0.10, 0.07), at);
}

Rgb count_colour(double count, double least, double most) {
  const double range = std::log(most / least);
  const double at = range > 0.0 ? std::log(count / least) / range : 0.0;
  const Rgb dark(0.05, 0.03, 0.20);
  const Rgb middle(0.75, 0.25, 0.40);
  const Rgb light(1.00, 0.95, 0.65);
  return at < 0.5 ? mixed(dark, middle, 2.0 * at) : mixed(middle, light, 2.0 * at - 1.0);
}

std::string base64(std::span<const unsigned char> bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      word = word << 8 | (k < count ? bytes[i + k] : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      out += k <= count ? digits[word >> (18 - 6 * k) & 63u] : '=';
    }
  }
  return out;
}

HtmlReport::HtmlReport(std::filesystem::path file) : file_(std::move(file)) {
  if (wanted()) {
    io::check_place(file_);
  }
}

void HtmlReport::picture(std::string explained, const RenderResult& result) {
  if (wanted()) {
    result_ = result;
    explained_ = std::move(explained);
  }
}

void HtmlReport::finish(const PictureReport& report) {
  if (!wanted()) {
    return;
  }
  Film& film = result_->film;
  const io::Image image{film.width, film.height, std::move(film.pixels)};
  sections_ += fmt::format(
      "<section>\n<h2>{}</h2>\n<p>{}</p>\n<div class=\"pictures\">\n{}{}</div>\n"
      "<h3>Time</h3>\n{}<h3>Rays</h3>\n{}<h3>The plan</h3>\n<pre>{}</pre>\n"
      "<h3>Options in force</h3>\n{}</section>\n",
      html_escaped(report.picture), html_escaped(summary(report)),
      picture_tag(image, report.options.encoding, "The picture"), maps(report.options, *result_),
      phases_table(report.phases), rays_table(report.statistics), html_escaped(explained_),
      options_table(report.options));
}

void HtmlReport::write(const std::filesystem::path& scene) const {
  if (wanted()) {
    const std::string page = html_page(scene.filename().string(), sections_);
    io::write_whole_file(file_, {reinterpret_cast<const unsigned char*>(page.data()), page.size()});
  }
}

}  // namespace rt::cli
