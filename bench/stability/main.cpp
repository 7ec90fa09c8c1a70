#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "stability/report.h"

/// Prints the stability suite's tables: bench_stability > bench/results/stability.md
int main(int argc, char** argv) {
  rt::bench::Options options;
  CLI::App app("The stability suite, in full, as Markdown");
  app.add_option("--rays", options.rays, "rays per family");
  app.add_option("--other-rays", options.other_rays, "rays per family for the other torus methods");
  app.add_option("--secondary", options.secondary, "rays that leave a surface; 0: leave them out");
  app.add_option("--threads", options.threads, "threads, for all but the times");
  CLI11_PARSE(app, argc, argv);
  fmt::print("# Intersections where methods fail\n\n{}\n", circumstances(options));
  fmt::print(
      "An answer is wrong when it is not the first crossing as 50 digits give it. In parentheses: "
      "wrong, but right for a surface moved by 1e-14 of the shape's size. Errors are distances "
      "from "
      "the surface along its normal beyond the last place of t; `point` is the same of the refined "
      "surface point, `normal` the normal's deviation from unit length.\n\n");
  const std::vector<rt::bench::Figures> own = own_figures(options);
  fmt::print("## Torus, methods side by side\n\n{}\n", torus_tables(options, own));
  std::fflush(stdout);
  fmt::print("## Every shape\n\n{}\n", shape_table(own));
  std::fflush(stdout);
  if (options.secondary > 0) {
    fmt::print(
        "## Leaving a surface\n\nSecondary rays from spheres, boxes, cylinders, cones, blobs, "
        "thick, "
        "spindle and thin tori, and closed meshes (a box, a sphere, a torus), at scales 1e-8 to "
        "1e8, turned, at the world's origin and 1e3 sizes "
        "away from it; a quarter of them within 1e-9 to 1e-1 of the tangent plane, on "
        "meshes half of them near an edge. Below "
        "resolution: "
        "decided otherwise for a surface moved by the error of the ray's origin.\n\n{}",
        leaving_table(options));
  }
  return 0;
}
