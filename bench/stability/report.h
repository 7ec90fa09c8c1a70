#pragma once
#include <string>

namespace rt::bench {

struct Options {
  long rays = 1'000'000;        ///< per family, this program's solvers
  long other_rays = 1'000'000;  ///< per family, each other torus solver
  long secondary = 0;           ///< rays that leave a surface, over all placements
  int threads = 1;              ///< for accuracy; times are always taken on one
};

/// Machine, compiler and today's date, as a paragraph.
std::string circumstances(const Options& options);
/// Cost, misses, false hits and error of the torus methods, side by side.
std::string torus_tables(const Options& options);
/// This program's solvers on every family of every shape.
std::string shape_table(const Options& options);
/// The policies for leaving a surface.
std::string leaving_table(const Options& options);

}  // namespace rt::bench
