#include "rt/scene/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace rt {
namespace {

std::string shown(const OptionValue& value) {
  if (const auto* b = std::get_if<bool>(&value)) {
    return *b ? "true" : "false";
  }
  if (const auto* d = std::get_if<double>(&value)) {
    return fmt::format("{}", *d);
  }
  return fmt::format("'{}'", std::get<std::string>(value));
}

[[noreturn]] void refuse(std::string_view expected, const OptionValue& value) {
  throw std::invalid_argument(fmt::format("expected {}, got {}", expected, shown(value)));
}

double as_number(const OptionValue& value, std::string_view expected) {
  if (const auto* d = std::get_if<double>(&value)) {
    return *d;
  }
  if (const auto* s = std::get_if<std::string>(&value)) {
    double d = 0.0;
    const auto [end, error] = std::from_chars(s->data(), s->data() + s->size(), d);
    if (error == std::errc() && end == s->data() + s->size()) {
      return d;
    }
  }
  refuse(expected, value);
}

double as_number_in(const OptionValue& value, double lo, double hi) {
  const std::string expected = fmt::format("a number from {} to {}", lo, hi);
  const double d = as_number(value, expected);
  if (!(d >= lo && d <= hi)) {
    refuse(expected, value);
  }
  return d;
}

/// A whole number in [lo, hi]; `hi` at most 2^53, so that every double in range is exact.
std::int64_t as_whole(const OptionValue& value, std::int64_t lo, std::int64_t hi) {
  const std::string expected = fmt::format("a whole number from {} to {}", lo, hi);
  const double d = as_number(value, expected);
  if (!(d >= static_cast<double>(lo) && d <= static_cast<double>(hi)) || d != std::floor(d)) {
    refuse(expected, value);
  }
  return static_cast<std::int64_t>(d);
}

bool as_switch(const OptionValue& value) {
  if (const auto* b = std::get_if<bool>(&value)) {
    return *b;
  }
  refuse("true or false", value);
}

template <class E, std::size_t N>
E as_choice(const OptionValue& value,
            const std::array<std::pair<std::string_view, E>, N>& choices) {
  std::string expected;
  for (const auto& [name, choice] : choices) {
    if (const auto* s = std::get_if<std::string>(&value); s && *s == name) {
      return choice;
    }
    expected += fmt::format("{}'{}'", expected.empty() ? "one of " : ", ", name);
  }
  refuse(expected, value);
}

template <class E, std::size_t N>
OptionValue name_of(E value, const std::array<std::pair<std::string_view, E>, N>& choices) {
  for (const auto& [name, choice] : choices) {
    if (choice == value) {
      return std::string(name);
    }
  }
  return std::string();
}

constexpr std::int64_t max_count = std::int64_t{1} << 30;
constexpr std::int64_t max_seed = std::int64_t{1} << 53;

constexpr std::array encodings{std::pair{std::string_view("srgb"), Encoding::srgb},
                               std::pair{std::string_view("raw"), Encoding::raw}};
constexpr std::array accels{std::pair{std::string_view("auto"), AccelChoice::automatic},
                            std::pair{std::string_view("none"), AccelChoice::none},
                            std::pair{std::string_view("list"), AccelChoice::list},
                            std::pair{std::string_view("grid"), AccelChoice::grid},
                            std::pair{std::string_view("bvh"), AccelChoice::bvh}};

constexpr std::array filters{
    std::pair{std::string_view("gaussian"), Filter::gaussian},
    std::pair{std::string_view("box"), Filter::box},
    std::pair{std::string_view("tent"), Filter::tent},
    std::pair{std::string_view("blackman-harris"), Filter::blackman_harris}};
constexpr std::array schemes{std::pair{std::string_view("adaptive"), AntiAliasing::adaptive},
                             std::pair{std::string_view("corners"), AntiAliasing::corners},
                             std::pair{std::string_view("uniform"), AntiAliasing::uniform}};

template <bool RenderOptions::*member>
constexpr OptionSpec feature(std::string_view name, std::string_view help) {
  return {name,
          "",
          help,
          [](RenderOptions& o, const OptionValue& v) { o.*member = as_switch(v); },
          [](const RenderOptions& o) { return OptionValue(o.*member); },
          false};
}

constexpr std::array specs{
    OptionSpec{"samples", "N",
               "samples of every pixel, not adaptive; 1 takes the pixel's centre",
               [](RenderOptions& o, const OptionValue& v) {
                 o.samples = static_cast<int>(as_whole(v, 1, max_count));
               },
               [](const RenderOptions& o) { return OptionValue(static_cast<double>(o.samples)); }},
    OptionSpec{
        "max_error", "E", "error a pixel may have, as displayed, of 1 (default 0.02)",
        [](RenderOptions& o, const OptionValue& v) { o.max_error = as_number_in(v, 1e-6, 1.0); },
        [](const RenderOptions& o) { return OptionValue(o.max_error); }},
    OptionSpec{
        "max_samples", "N", "where an adaptive pixel gives up (default 4096)",
        [](RenderOptions& o, const OptionValue& v) {
          o.max_samples = static_cast<int>(as_whole(v, 1, max_count));
        },
        [](const RenderOptions& o) { return OptionValue(static_cast<double>(o.max_samples)); }},
    OptionSpec{
        "time_limit", "S", "seconds to trace for; the picture is then as good as it got",
        [](RenderOptions& o, const OptionValue& v) { o.time_limit = as_number_in(v, 1e-3, 1e9); },
        [](const RenderOptions& o) { return OptionValue(o.time_limit); }},
    OptionSpec{"filter", "NAME", "pixel filter: gaussian (default), box, tent, blackman-harris",
               [](RenderOptions& o, const OptionValue& v) { o.filter = as_choice(v, filters); },
               [](const RenderOptions& o) { return name_of(o.filter, filters); }},
    OptionSpec{"aa", "adaptive|corners|uniform",
               "samples: by estimated error (default), where corners differ, 16 everywhere",
               [](RenderOptions& o, const OptionValue& v) { o.aa = as_choice(v, schemes); },
               [](const RenderOptions& o) { return name_of(o.aa, schemes); }},
    OptionSpec{"seed", "N", "seed of all random decisions (default 0)",
               [](RenderOptions& o, const OptionValue& v) {
                 o.seed = static_cast<std::uint64_t>(as_whole(v, 0, max_seed));
               },
               [](const RenderOptions& o) { return OptionValue(static_cast<double>(o.seed)); }},
    OptionSpec{
        "max_depth", "N", "bounces a path may take (default 8)",
        [](RenderOptions& o, const OptionValue& v) {
          o.max_depth = static_cast<int>(as_whole(v, 0, 10'000));
        },
        [](const RenderOptions& o) { return OptionValue(static_cast<double>(o.max_depth)); }},
    OptionSpec{"encoding", "srgb|raw",
               "8-bit pictures hold sRGB (default) or the linear value times 255",
               [](RenderOptions& o, const OptionValue& v) { o.encoding = as_choice(v, encodings); },
               [](const RenderOptions& o) { return name_of(o.encoding, encodings); }},
    OptionSpec{"accel", "auto|none|list|grid|bvh",
               "how hits are found: by the scene's size (default), one by one, boxes in a list, "
               "uniform grid, hierarchy",
               [](RenderOptions& o, const OptionValue& v) { o.accel = as_choice(v, accels); },
               [](const RenderOptions& o) { return name_of(o.accel, accels); }},
    feature<&RenderOptions::reflection>("reflection", "mirror reflection"),
    feature<&RenderOptions::refraction>("refraction", "refraction; off: transparent is opaque"),
    feature<&RenderOptions::soft_shadows>("soft_shadows", "extended lights; off: all are points"),
    feature<&RenderOptions::glossy>("glossy", "blurred reflection; off: all mirrors are perfect"),
    feature<&RenderOptions::antialiasing>("antialiasing", "more than one sample a pixel"),
    feature<&RenderOptions::adaptive>("adaptive", "more samples where the error asks for them"),
    feature<&RenderOptions::motion_blur>("motion_blur", "movement while the shutter is open"),
    feature<&RenderOptions::textures>("textures", "pictures and checkers on surfaces"),
    feature<&RenderOptions::noise>("noise", "patterns of noise on surfaces"),
    feature<&RenderOptions::texture_filter>(
        "texture_filter", "filtering of textures over a sample's footprint; off only to compare"),
    feature<&RenderOptions::acceleration>("acceleration", "anything but trying shapes one by one"),
};

bool same_name(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return (x == '-' ? '_' : x) == (y == '-' ? '_' : y); });
}

/// Levenshtein distance.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) {
    row[j] = j;
  }
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({substituted, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

}  // namespace

int fixed_samples(const RenderOptions& options) {
  constexpr int uniform_samples = 16;
  if (!options.antialiasing) {
    return 1;
  }
  if (options.samples > 0) {
    return options.samples;
  }
  const bool uniform = options.aa == AntiAliasing::uniform ||
                       (options.aa == AntiAliasing::adaptive && !options.adaptive);
  return uniform ? uniform_samples : 0;
}

std::span<const OptionSpec> option_specs() { return specs; }

const OptionSpec* find_option(std::string_view name) {
  const auto* found = std::find_if(specs.begin(), specs.end(),
                                   [&](const OptionSpec& s) { return same_name(s.name, name); });
  return found == specs.end() ? nullptr : found;
}

void parse_size(std::string_view text, int& width, int& height) {
  constexpr int largest = 65'536;
  int w = 0;
  int h = 0;
  const char* end = text.data() + text.size();
  auto [x, w_error] = std::from_chars(text.data(), end, w);
  bool good = w_error == std::errc() && x != end && (*x == 'x' || *x == 'X');
  if (good) {
    const auto [rest, h_error] = std::from_chars(x + 1, end, h);
    good = h_error == std::errc() && rest == end;
  }
  if (!good || w < 1 || h < 1 || w > largest || h > largest) {
    throw std::invalid_argument(
        fmt::format("expected WIDTHxHEIGHT with both from 1 to {}, got '{}'", largest, text));
  }
  width = w;
  height = h;
}

std::string nearest_name(std::string_view given, std::span<const std::string_view> known) {
  // A slip in a third of the letters, or two letters swapped in a short word, is still a
  // misspelling.
  const std::size_t limit = std::max<std::size_t>(2, given.size() / 3);
  std::string best;
  std::size_t best_distance = limit + 1;
  for (const std::string_view name : known) {
    const std::size_t distance = edit_distance(given, name);
    if (distance < best_distance && distance < name.size()) {
      best_distance = distance;
      best = name;
    }
  }
  return best;
}

}  // namespace rt
