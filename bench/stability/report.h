#pragma once
#include <string>
#include <vector>

#include "stability/checker.h"

namespace rt::bench {

struct Options {
  long rays = 1'000'000;        ///< per family, this program's solvers
  long other_rays = 1'000'000;  ///< per family, each other torus solver
  long secondary = 0;           ///< rays that leave a surface, over all placements
  int threads = 1;              ///< for accuracy; times are always taken on one
};

/// What came of this program's solver on one family.
struct Figures {
  stability::Family family;
  stability::Tally tally;  ///< without the single errors of t
  double t_error = 0;      ///< relative, at p99.9
};

/// Of every family of every shape; each is reported on standard error when it is done.
std::vector<Figures> own_figures(const Options& options);

/// Machine, compiler and today's date, as a paragraph.
std::string circumstances(const Options& options);
/// Cost, misses, false hits and error of the torus methods, side by side.
std::string torus_tables(const Options& options, const std::vector<Figures>& own);
/// This program's solvers on every family of every shape.
std::string shape_table(const std::vector<Figures>& own);
/// The policies for leaving a surface.
std::string leaving_table(const Options& options);

}  // namespace rt::bench
