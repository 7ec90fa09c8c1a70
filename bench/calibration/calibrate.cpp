/// Does an error target mean what it says? Renders scenes at several targets and compares with
/// references of many samples; bench/charting/calibration.py makes tables and a chart of it.
///
///   calibrate [-r SAMPLES] [-s WxH] [-c CACHE_FOLDER] [-e E]... SCENE.lua...     CSV on stdout
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <string>
#include <vector>

#include "rt/io/obj.h"
#include "rt/io/texture.h"
#include "rt/lua/script.h"
#include "rt/math/srgb.h"
#include "rt/render/plan.h"
#include "rt/render/render.h"
#include "rt/render/threads.h"

namespace rt {
namespace {

struct Settings {
  int reference_samples = 16384;
  int width = 64, height = 48;
  std::filesystem::path cache = "calibration-cache";
  std::vector<double> targets;
  std::vector<std::filesystem::path> scenes;
};

RenderJob first_job(const std::filesystem::path& script) {
  std::optional<RenderJob> job;
  const lua::Host host{
      .render =
          [&](RenderJob j) {
            if (!job) {
              job = std::move(j);
            }
          },
      .load_mesh = io::load_obj,
      .open_texture = [](const std::filesystem::path& file) { return io::open_texture(file); },
      .warn = [](const std::string&) {}};
  lua::run_script(script, {}, host);
  return std::move(*job);
}

RenderResult rendered(const RenderJob& job) {
  std::optional<RenderResult> result;
  with_threads(0, [&] {
    result = render(make_plan(job), {0, 0, job.options.width, job.options.height}, {});
  });
  return std::move(*result);
}

/// A reference of other random numbers than the picture's, from the cache if it is there.
std::vector<float> reference(RenderJob job, const Settings& settings, const std::string& name) {
  const auto file = settings.cache / fmt::format("{}-{}x{}-{}.raw", name, settings.width,
                                                 settings.height, settings.reference_samples);
  std::vector<float> pixels(3 * static_cast<std::size_t>(settings.width * settings.height));
  const auto bytes = static_cast<std::streamsize>(pixels.size() * sizeof(float));
  if (std::ifstream in(file, std::ios::binary);
      in.read(reinterpret_cast<char*>(pixels.data()), bytes)) {
    return pixels;
  }
  job.options.samples = settings.reference_samples;
  job.options.max_error = 1e-4;  // leaves out next to nothing
  job.options.seed += 12345;
  pixels = rendered(job).film.pixels;
  std::filesystem::create_directories(settings.cache);
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(pixels.data()), bytes);
  return pixels;
}

double shown(float value, Encoding encoding) {
  const double v = std::clamp(double{value}, 0.0, 1.0);
  return encoding == Encoding::srgb ? srgb_oetf(v) : v;
}

/// The error of a pixel as displayed: the largest over channels, and the signed mean over them.
struct PixelError {
  double largest, bias;
};

PixelError pixel_error(const float* a, const float* b, Encoding encoding) {
  PixelError e{0.0, 0.0};
  for (int k = 0; k < 3; ++k) {
    const double d = shown(a[k], encoding) - shown(b[k], encoding);
    e.largest = std::max(e.largest, std::abs(d));
    e.bias += d / 3.0;
  }
  return e;
}

double mean(const std::vector<double>& v) {
  return v.empty() ? 0.0 : std::accumulate(v.begin(), v.end(), 0.0) / static_cast<double>(v.size());
}

double percentile(std::vector<double> v, double p) {
  if (v.empty()) {
    return 0.0;
  }
  const auto rank = static_cast<std::ptrdiff_t>(p * static_cast<double>(v.size() - 1));
  std::nth_element(v.begin(), v.begin() + rank, v.end());
  return v[static_cast<std::size_t>(rank)];
}

void judge(const std::string& name, RenderJob job, double target, const std::vector<float>& truth) {
  job.options.max_error = target;
  job.options.samples = 0;
  job.options.aa = AntiAliasing::adaptive;
  const RenderResult result = rendered(job);
  std::vector<double> all, refined, bias;
  double claimed = 0.0;
  double linear = 0.0;
  for (std::size_t i = 0; i < result.samples.size(); ++i) {
    const float* a = &result.film.pixels[3 * i];
    const PixelError e = pixel_error(a, &truth[3 * i], job.options.encoding);
    all.push_back(e.largest);
    bias.push_back(e.bias);
    claimed += double{result.errors[i]} / static_cast<double>(result.errors.size());
    if (result.samples[i] > result.pilots[i]) {
      refined.push_back(e.largest);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const double d = double{a[k]} - double{truth[3 * i + k]};
      linear += d * d;
    }
  }
  const auto pixels = static_cast<double>(all.size());
  std::vector<double> squares(bias.size());
  std::transform(bias.begin(), bias.end(), squares.begin(), [](double b) { return b * b; });
  const double bias_error = std::sqrt(mean(squares) / pixels);
  const auto held = static_cast<double>(
      std::count_if(all.begin(), all.end(), [&](double e) { return e <= target; }));
  fmt::print(
      "{},{},{},{},{:.2f},{:.5f},{:.5f},{:.3f},{:.5f},{:.3f},{:.6f},{:.6f},{:.3f},{:.4f},"
      "{:.6f},{}\n",
      name, target, all.size(), refined.size(),
      static_cast<double>(result.statistics.samples) / pixels, claimed, mean(refined),
      mean(refined) / target, percentile(refined, 0.95), percentile(refined, 0.95) / target,
      mean(bias), bias_error, std::abs(mean(bias)) / target, held / pixels,
      std::sqrt(linear / (3.0 * pixels)), result.reached->unreached);
  std::fflush(stdout);
}

Settings parse(int argc, char** argv) {
  Settings s;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "-r") {
      s.reference_samples = std::atoi(argv[++i]);
    } else if (word == "-s") {
      parse_size(argv[++i], s.width, s.height);
    } else if (word == "-c") {
      s.cache = argv[++i];
    } else if (word == "-e") {
      s.targets.push_back(std::atof(argv[++i]));
    } else {
      s.scenes.emplace_back(word);
    }
  }
  if (s.targets.empty()) {
    s.targets = {0.05, 0.02, 0.01, 0.005};
  }
  return s;
}

int run(int argc, char** argv) {
  const Settings settings = parse(argc, argv);
  fmt::print(
      "scene,target,pixels,refined,samples_per_pixel,mean_claimed,refined_mean,"
      "refined_mean/E,refined_p95,refined_p95/E,bias,bias_error,bias/E,share_within_E,"
      "linear_rmse,out_of_samples\n");
  for (const auto& scene : settings.scenes) {
    RenderJob job = first_job(scene);
    job.options.width = settings.width;
    job.options.height = settings.height;
    job.options.time_limit = 0.0;
    const std::string name = scene.stem();
    const std::vector<float> truth = reference(job, settings, name);
    for (const double target : settings.targets) {
      judge(name, job, target, truth);
    }
  }
  return 0;
}

}  // namespace
}  // namespace rt

int main(int argc, char** argv) { return rt::run(argc, argv); }
