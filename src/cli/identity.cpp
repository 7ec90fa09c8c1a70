#include "rt/cli/identity.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "rt/math/bytes.h"

namespace rt::cli {
namespace fs = std::filesystem;
namespace {

std::string shown(std::uint64_t digest) { return fmt::format("{:016x}", digest); }

void add(ByteWriter& out, const Camera& camera) {
  for (const Vec3& v : {camera.eye, camera.view, camera.up}) {
    out.value(v);
  }
  for (const double d : {camera.fov, camera.aperture, camera.focus}) {
    out.value(d);
  }
  if (camera.to) {
    add(out, *camera.to);
  }
}

void add(ByteWriter& out, const Light& light) {
  for (const Vec3& v : {light.position, light.colour, light.travel}) {
    out.value(v);
  }
  for (const double d : {light.falloff.c0, light.falloff.c1, light.falloff.c2, light.radius}) {
    out.value(d);
  }
  if (light.rectangle) {
    out.value(light.rectangle->u);
    out.value(light.rectangle->v);
  }
  out.value(light.visible);
}

void add(ByteWriter& out, const Instance& instance) {
  const Affine& map = instance.world_from_model;
  for (int k = 0; k < 3; ++k) {
    out.value(map.linear[k]);
  }
  out.value(map.offset);
  const Bounds extent = std::visit([](const auto& s) { return bounds(s); }, *instance.shape);
  out.value(extent.lo);
  out.value(extent.hi);
  const Material& m = *instance.material;
  for (const Rgb& c : {m.kd, m.ks, m.reflectivity, m.absorption, m.emission}) {
    out.value(c);
  }
  for (const double d : {m.shininess, m.ior, m.opacity, m.glossiness}) {
    out.value(d);
  }
  out.value(std::uint64_t{instance.shape->index()});
  for (std::size_t i = 0; i < texture_slots; ++i) {
    const TextureSet::Entry* entry = instance.textures ? &instance.textures->entries[i] : nullptr;
    out.value(entry != nullptr && entry->texture != nullptr);
    out.value(entry != nullptr ? entry->strength : 0.0);
  }
  out.value(instance.motion != nullptr);
}

}  // namespace

std::string first_difference(const Facts& now, const Facts& then) {
  for (const Fact& fact : now) {
    const auto old = std::ranges::find(then, fact.name, &Fact::name);
    if (old == then.end()) {
      return fmt::format("{} was not there", fact.name);
    }
    if (old->value != fact.value) {
      return fmt::format("{} is {}, and was {}", fact.name, fact.value, old->value);
    }
  }
  return {};
}

InputFiles::Stamp InputFiles::stamp_of(const fs::path& file) {
  std::error_code error;
  return {fs::file_size(file, error), fs::last_write_time(file, error)};
}

void InputFiles::note(const fs::path& file) { inputs_.try_emplace(file, stamp_of(file)); }

Facts InputFiles::facts() const {
  Facts facts;
  for (const auto& [path, stamp] : inputs_) {
    const Stamp now = stamp_of(path);
    facts.push_back({fmt::format("the file {}", path.string()),
                     now == stamp ? shown(digest_of_file(path))
                                  : fmt::format("changed while the program ran, at {}",
                                                now.changed.time_since_epoch().count())});
  }
  return facts;
}

std::uint64_t digest_of_file(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) {
    return 0;
  }
  std::ifstream in(file, std::ios::binary);
  std::vector<unsigned char> part(1 << 20);
  std::uint64_t key = 0;
  while (in) {
    in.read(reinterpret_cast<char*>(part.data()), static_cast<std::streamsize>(part.size()));
    key = digest(Bytes(part).first(static_cast<std::size_t>(in.gcount())), key);
  }
  return in.eof() ? key : 0;
}

Facts facts_of_run(const CommandLine& line) {
  std::string arguments;
  for (const std::string& argument : line.arguments) {
    arguments += fmt::format("{}'{}'", arguments.empty() ? "" : " ", argument);
  }
  const bool post = line.script.order == TransformOrder::post;
  const std::string frames =
      line.frames ? fmt::format("{}..{}", line.frames->first, line.frames->last) : "not given";
  return {{"the program's version", RT_VERSION},
          {"the program's build", shown(digest_of_file("/proc/self/exe"))},
          {"what follows --", arguments.empty() ? "nothing" : arguments},
          {"--frames", frames},
          {"--transform-order", post ? "post" : "pre"},
          {"--lenient", line.script.lenient ? "given" : "not given"},
          {"--trust", line.script.trust ? "given" : "not given"}};
}

Facts facts_of_options(const RenderOptions& options, const Crop& crop) {
  Facts facts{{"the picture's size", fmt::format("{}x{}", options.width, options.height)},
              {"the crop", fmt::format("{},{},{},{}", crop.x, crop.y, crop.width, crop.height)}};
  for (const OptionSpec& spec : option_specs()) {
    if (spec.name != "time_limit") {
      std::visit(
          [&](const auto& v) {
            facts.push_back({fmt::format("the option {}", spec.name), fmt::format("{}", v)});
          },
          spec.get(options));
    }
  }
  return facts;
}

Fact fact_of_scene(const RenderJob& job) {
  ByteWriter rest;
  add(rest, job.camera);
  rest.value(job.ambient);
  for (const Rgb& c : {job.options.background.top, job.options.background.bottom}) {
    rest.value(c);
  }
  rest.value(job.options.shutter_open);
  rest.value(job.options.shutter_close);
  for (const Light& light : job.lights) {
    add(rest, light);
  }
  std::uint64_t key = digest(rest.bytes());
  for (const Instance& instance : job.instances) {
    ByteWriter one;
    add(one, instance);
    key = digest(one.bytes(), key);
  }
  return {"the scene that the script makes (does it use the time?)", shown(key)};
}

}  // namespace rt::cli
