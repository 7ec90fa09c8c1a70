#pragma once
/// The options of a rendering: declared once, here, for scripts, command line, help and
/// annotations.
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "rt/math/filter.h"
#include "rt/math/vec.h"

namespace rt {

/// How 8-bit pictures encode linear values.
enum class Encoding { srgb, raw };
/// How the ray's candidates are found.
enum class AccelChoice { automatic, none, list, grid, bvh };

/// How a pixel is made from samples.
enum class AntiAliasing {
  adaptive,  ///< as many as its estimated error asks for
  corners,   ///< the classic scheme: squares are divided while their corners differ
  uniform    ///< the same number for every pixel
};

/// A constant or a vertical gradient over the picture's height.
struct Background {
  Rgb top{0.0};
  Rgb bottom{0.0};
};

struct RenderOptions {
  int width = 0;
  int height = 0;
  int max_depth = 8;        ///< how many times a path may be reflected or refracted
  double max_error = 0.02;  ///< accepted error of a pixel, in displayed 0..1 units
  int samples = 0;          ///< per pixel, fixed; 1 is the pixel's centre; 0: left to `aa`
  int max_samples = 4096;   ///< no pixel takes more, unless `samples` says so
  double time_limit = 0.0;  ///< seconds of wall time for tracing; 0: none
  Filter filter = Filter::gaussian;
  AntiAliasing aa = AntiAliasing::adaptive;
  std::uint64_t seed = 0;
  Encoding encoding = Encoding::srgb;
  AccelChoice accel = AccelChoice::automatic;
  bool reflection = true;
  bool refraction = true;    ///< false: transparent things are opaque
  bool soft_shadows = true;  ///< false: every light is a point
  bool glossy = true;        ///< false: every mirror is perfect
  bool antialiasing = true;  ///< false: one sample at the pixel's centre
  bool adaptive = true;      ///< false: `aa` is uniform unless it is corners
  bool acceleration = true;
  bool motion_blur = true;     ///< false: all stands as it is when the shutter opens
  bool textures = true;        ///< false: pictures and checkers are left out
  bool noise = true;           ///< false: so are patterns of noise
  bool texture_filter = true;  ///< false: textures are read at points, to compare
  Background background;
  double shutter_open = 0.0, shutter_close = 1.0;  ///< 0 <= open <= close <= 1
};

/// The samples that every pixel takes, all options considered; 0 when it is not a fixed number.
int fixed_samples(const RenderOptions& options);

/// What a script or the command line gives for an option. The command line gives strings.
using OptionValue = std::variant<bool, double, std::string>;

struct OptionSpec {
  std::string_view name;   ///< as in a script's table: max_depth; the flag is --max-depth
  std::string_view value;  ///< placeholder in help: "N"
  std::string_view help;   ///< one line
  /// Checks the value and stores it. Throws std::invalid_argument "expected ..., got ...".
  void (*set)(RenderOptions&, const OptionValue&);
  /// The value in force, for reports.
  OptionValue (*get)(const RenderOptions&);
  bool on_command_line = true;  ///< has a flag; else only --disable names it
};

/// Every option there is.
std::span<const OptionSpec> option_specs();

/// The option of that name, '-' and '_' alike; null when there is none.
const OptionSpec* find_option(std::string_view name);

/// "800x600" as width and height; throws std::invalid_argument.
void parse_size(std::string_view text, int& width, int& height);

/// The name among `known` with the smallest edit distance to `given`, or empty when none is near
/// enough to be a likely misspelling.
std::string nearest_name(std::string_view given, std::span<const std::string_view> known);

}  // namespace rt
