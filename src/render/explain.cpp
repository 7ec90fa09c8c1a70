#include "rt/render/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>

#include "rt/math/wide.h"
#include "rt/render/adaptive.h"
#include "rt/render/sample.h"
#include "rt/render/thin.h"

namespace rt {
namespace {

/// Rows and columns of the rays that the cost is estimated from.
constexpr int probes = 24;                     ///< across the picture, and down
constexpr std::uint32_t samples_of_probe = 8;  ///< neighbours go together

std::string counted(std::size_t n, const std::string& what) {
  const char* plural = what.ends_with('x') || what.ends_with("sh") ? "es" : "s";
  return fmt::format("{} {}{}", n, what, n == 1 ? "" : plural);
}

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

struct Counts {
  std::map<std::string, std::size_t> kinds;
  std::size_t moving = 0, textured = 0, glass = 0, mirrors = 0, glossy = 0, absorbing = 0;
  std::size_t points = 0, extended = 0;
};

Counts counts_of(const RenderPlan& plan) {
  Counts c;
  for (const PlannedInstance& i : plan.instances) {
    const PlannedMaterial& m = plan.material_of(i);
    ++c.kinds[plan.visit(i, [](const auto& s) { return shape_kind(s); })];
    c.moving += i.moves() ? 1 : 0;
    c.textured += m.textures ? 1 : 0;
    c.glass += m.transmissive ? 1 : 0;
    c.mirrors += !m.transmissive && m.reflectivity != Rgb(0.0) ? 1 : 0;
    c.glossy += m.lobe ? 1 : 0;
    c.absorbing += m.transmissive && m.absorption != Rgb(0.0) ? 1 : 0;
  }
  for (const PlannedLight& light : plan.lights) {
    ++(light.extended() ? c.extended : c.points);
  }
  return c;
}

/// The lines of one part of the text.
class Part {
 public:
  explicit Part(const std::string& title) : text_(title + "\n") {}
  void line(const std::string& name, const std::string& what) {
    text_ += fmt::format("  {:<14} {}\n", name, what);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

std::string scene(const RenderPlan& plan, const Counts& c) {
  std::vector<std::string> kinds;
  for (const auto& [kind, n] : c.kinds) {
    kinds.push_back(fmt::format("{} {}", n, kind));
  }
  return fmt::format("The scene: {} ({}), {}, {} x {} pixels\n",
                     counted(plan.instances.size(), "shape"), joined(kinds),
                     counted(plan.lights.size(), "light"), plan.options.width, plan.options.height);
}

std::string search(const RenderPlan& plan) {
  const std::string boxes = counted(plan.bounded, "box");
  if (plan.list) {
    return boxes + " in a list, tested eight at a time: " +
           (plan.options.accel == AccelChoice::list ? "as asked for"
                                                    : "with so few a hierarchy would cost more");
  }
  if (plan.tree) {
    return boxes + " in a hierarchy, eight to a node: its cost grows with the logarithm";
  }
  if (plan.grid) {
    return boxes + " in a uniform grid, as asked for";
  }
  return plan.bounded == 0 ? "nothing that a box could hold" : "shapes one by one, as asked for";
}

std::string pixels(const RenderOptions& o) {
  if (const int n = fixed_samples(o); n > 0) {
    return n == 1 ? "one sample at each pixel's centre"
                  : fmt::format("{} samples a pixel, as asked for", n);
  }
  if (o.aa == AntiAliasing::corners) {
    return "the classic scheme: squares are divided while their corners differ";
  }
  return fmt::format(
      "adaptive: {} samples a pixel, then as many as an error of {:g} needs, {} at most",
      pilot_samples, o.max_error, o.max_samples);
}

std::string chosen(const RenderPlan& plan, const Counts& c) {
  const RenderOptions& o = plan.options;
  Part part("What it needs, and what was chosen for it:");
  part.line("search", search(plan));
  if (!plan.unbounded().empty()) {
    part.line("planes",
              counted(plan.unbounded().size(), "plane") + " without end, tested by every ray");
  }
  const auto meshes =
      std::ranges::count_if(plan.mesh_trees, [](const auto& tree) { return tree != nullptr; });
  if (meshes > 0) {
    part.line("meshes", counted(static_cast<std::size_t>(meshes), "mesh") +
                            " with a hierarchy each, shared by all instances");
  }
  part.line("samples",
            fmt::format("{} at a time, as the processor's registers hold numbers{}", lanes,
                        c.moving > 0 ? "; what moves meets their rays one by one" : ""));
  if ((plan.list || plan.tree) && !plan.moving_camera && plan.camera.lens_radius == 0.0) {
    part.line("sight",
              "camera rays only try what a block of 8 x 8 pixels can show, where that is little");
  }
  const bool cells = plan.list || (plan.tree && c.extended > 0);
  if (cells && !plan.lights.empty()) {
    part.line("shadows", "what may shadow a cell of some 16 pixels is remembered for each light");
  }
  part.line("pixels", pixels(o));
  if (plan.thin) {
    part.line("thin things",
              "some shapes are narrower than a pixel: pixels on them begin with more samples");
  }
  if (c.extended > 0) {
    part.line("soft shadows", counted(c.extended, "light") +
                                  " with an extent: a line across each, a sample, past few things; "
                                  "past many a shadow ray");
  }
  if (c.glass > 0) {
    part.line("glass",
              counted(c.glass, "shape") +
                  (plan.random ? ": both ways are followed while it matters, then one by chance"
                               : ": both ways are followed, nothing is left to chance"));
  }
  if (c.absorbing > 0) {
    part.line("absorption", counted(c.absorbing, "shape") + " dim by the length of the way inside");
  }
  if (c.mirrors > 0) {
    part.line("mirrors",
              fmt::format("{}, up to {} deep", counted(c.mirrors, "shape"), o.max_depth));
  }
  if (c.glossy > 0) {
    part.line("gloss", counted(c.glossy, "shape") + " blur what they reflect: one ray a sample");
  }
  if (plan.moves) {
    part.line("motion",
              (c.moving > 0 ? counted(c.moving, "shape") : std::string("camera or lights")) +
                  " move: every sample has a time");
  }
  if (plan.camera.lens_radius > 0.0) {
    part.line("lens", "what is out of focus is blurred: every sample has a place on the lens");
  }
  if (c.textured > 0) {
    part.line(
        "textures",
        counted(c.textured, "shape") +
            (plan.footprints ? ", filtered over each sample's footprint: rays carry differentials"
                             : ", looked up without a filter"));
  }
  return part.text();
}

std::string left_out(const RenderPlan& plan, const Counts& c) {
  std::vector<std::string> none;
  const auto absent = [&none](bool needed, const char* what) {
    if (!needed) {
      none.emplace_back(what);
    }
  };
  absent(plan.random, "random decisions");
  absent(c.extended > 0, "soft shadows");
  absent(c.glass > 0, "refraction");
  absent(plan.dims, "transparent shadows");
  absent(plan.absorbs, "absorption");
  absent(c.mirrors > 0, "mirrors");
  absent(c.glossy > 0, "gloss");
  absent(plan.moves, "motion");
  absent(plan.camera.lens_radius > 0.0, "a lens");
  absent(c.textured > 0, "textures and noise");
  absent(plan.footprints, "ray differentials");
  absent(plan.thin != nullptr, "thin things");
  return none.empty() ? std::string() : "Left out, and costing nothing: " + joined(none) + "\n";
}

void probe(PixelSampler& sampler, RenderStatistics& statistics) {
  const RenderOptions& o = sampler.plan().options;
  std::vector<PixelSample> wanted;
  for (int j = 0; j < probes; ++j) {
    for (int i = 0; i < probes; ++i) {
      const int x = (2 * i + 1) * o.width / (2 * probes);
      const int y = (2 * j + 1) * o.height / (2 * probes);
      for (std::uint32_t index = 0; index < samples_of_probe; ++index) {
        wanted.push_back({x, y, index});
      }
    }
  }
  std::vector<std::optional<Rgb>> values(wanted.size());
  sampler.take_all(wanted, values, statistics);
}

/// Rays a sample and seconds a sample, from samples spread over the picture. A first round fills
/// the caches; the second is timed.
std::pair<double, double> probed(const RenderPlan& plan) {
  PixelSampler sampler(plan);
  RenderStatistics first;
  probe(sampler, first);
  RenderStatistics statistics;
  const auto begin = std::chrono::steady_clock::now();
  probe(sampler, statistics);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
  const double n = std::max(1.0, static_cast<double>(statistics.samples));
  return {static_cast<double>(statistics.rays.total()) / n, spent.count() / n};
}

/// Two significant digits, without an exponent.
std::string rough(double x) {
  return x >= 10.0 ? fmt::format("{:.0f}", x) : fmt::format("{:.2g}", x);
}

std::string cost(const RenderPlan& plan, int threads) {
  const RenderOptions& o = plan.options;
  const auto [rays, seconds] = probed(plan);
  const int fixed = fixed_samples(o);
  const double least = fixed > 0 ? fixed : pilot_samples;
  const double picture = least * o.width * o.height * seconds / threads;
  std::string text = fmt::format(
      "To expect: {:.1f} rays and {} microseconds a sample, measured on {} of them; {}{} s "
      "on {}",
      rays, rough(1e6 * seconds), probes * probes * static_cast<int>(samples_of_probe), fixed > 0 ? "about " : "at least ",
      rough(picture), counted(static_cast<std::size_t>(threads), "thread"));
  if (fixed == 0) {
    text += ", more where edges, blur and soft light need more samples";
  }
  return text + "\n";
}

}  // namespace

std::string explain(const RenderPlan& plan, int threads) {
  const Counts c = counts_of(plan);
  return scene(plan, c) + chosen(plan, c) + left_out(plan, c) + cost(plan, threads);
}

}  // namespace rt
