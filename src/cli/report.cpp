#include "rt/cli/report.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <nlohmann/json.hpp>

#include "rt/io/whole_file.h"
#include "rt/math/bytes.h"

namespace rt::cli {
namespace {

using Json = nlohmann::ordered_json;

Json options_in_force(const RenderOptions& options) {
  Json json;
  for (const OptionSpec& spec : option_specs()) {
    std::visit([&](const auto& value) { json[std::string(spec.name)] = value; }, spec.get(options));
  }
  return json;
}

/// 0 where no time was measured: a picture can be traced within one tick of the clock.
double rays_per_second(const PictureReport& r) {
  const auto rays = static_cast<double>(r.statistics.rays.total());
  return r.phases.trace > 0.0 ? rays / r.phases.trace : 0.0;
}

Json picture(const PictureReport& r) {
  const RayCounts& rays = r.statistics.rays;
  Json json{
      {"picture", r.picture},
      {"size", {r.options.width, r.options.height}},
      {"crop", {r.crop.x, r.crop.y, r.crop.width, r.crop.height}},
      {"instances", r.instances},
      {"lights", r.lights},
      {"seconds",
       {{"script", r.phases.script},
        {"plan", r.phases.plan},
        {"trace", r.phases.trace},
        {"trace_cpu", r.phases.trace_cpu},
        {"write", r.phases.write}}},
      {"rays",
       {{"camera", rays.camera},
        {"shadow", rays.shadow},
        {"reflection", rays.reflection},
        {"refraction", rays.refraction},
        {"total", rays.total()},
        {"per_second", rays_per_second(r)}}},
      {"samples", r.statistics.samples},
      {"bad_samples", r.statistics.bad_samples},
      {"options", options_in_force(r.options)},
  };
  if (r.reached) {
    json["error"] = {{"mean", r.reached->mean},
                     {"percentile_99", r.reached->percentile_99},
                     {"pixels_above_target", r.reached->unreached},
                     {"out_of_time", r.reached->out_of_time}};
  }
  return json;
}

/// "; estimated error: mean 0.004, 99th percentile 0.019; 12 pixels ran out of samples above 0.02".
std::string error_summary(const PictureReport& r) {
  if (!r.reached) {
    return "";
  }
  const ReachedError& e = *r.reached;
  std::string text = fmt::format("; estimated error: mean {:.2g}, 99th percentile {:.2g}", e.mean,
                                 e.percentile_99);
  if (e.unreached > 0) {
    text += fmt::format("; {} pixel{} out of {} above {}", e.unreached,
                        e.unreached > 1 ? "s ran" : " ran", e.out_of_time ? "time" : "samples",
                        r.options.max_error);
  }
  return text;
}

}  // namespace

std::string summary(const PictureReport& r) {
  constexpr double million = 1e6;
  const auto rays = static_cast<double>(r.statistics.rays.total());
  const double pixels = static_cast<double>(r.crop.width) * r.crop.height;
  return fmt::format("{}: {}x{}, {:.3g} samples a pixel, {:.2f} s, {:.2f} M rays ({:.1f} M/s){}",
                     r.picture, r.crop.width, r.crop.height,
                     static_cast<double>(r.statistics.samples) / pixels, r.phases.trace,
                     rays / million, rays_per_second(r) / million, error_summary(r));
}

void write_stats(const std::filesystem::path& file, const std::filesystem::path& scene, int threads,
                 const io::TextureStatistics& textures, const std::vector<PictureReport>& reports) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  Json pictures = Json::array();
  for (const PictureReport& r : reports) {
    pictures.push_back(picture(r));
  }
  Json json{{"version", RT_VERSION},
            {"scene", scene.string()},
            {"threads", threads},
            {"peak_memory_bytes", static_cast<std::uint64_t>(usage.ru_maxrss) * 1024},
            {"pictures", pictures}};
  if (textures.files > 0) {
    json["textures"] = {{"files", textures.files},
                        {"lookups", textures.lookups},
                        {"cache_peak_bytes", textures.cache_peak},
                        {"load_seconds", textures.load_seconds}};
  }
  // File names may be in any encoding: what is not UTF-8 becomes U+FFFD.
  const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
  io::write_whole_file(file,
                       Bytes(reinterpret_cast<const unsigned char*>(text.data()), text.size()));
}

}  // namespace rt::cli
