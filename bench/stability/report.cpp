#include "stability/report.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <fstream>

#include "stability/leaving.h"
#include "stability/parallel.h"
#include "stability/solvers.h"
#include "stability/timing.h"

namespace rt::bench {
namespace {

using stability::Family;
using stability::Policy;
using stability::Tally;

struct TorusCase {
  Torus torus;
  Ray ray;
};

std::string count_of(long n, long rays) {
  return n == 0 ? "0"
                : fmt::format("{:.3g}", 1e6 * static_cast<double>(n) / static_cast<double>(rays));
}

/// "outright (below resolution)" per million.
std::string failures(long outright, long below, long rays) {
  return below == 0 ? count_of(outright, rays)
                    : fmt::format("{} ({})", count_of(outright, rays), count_of(below, rays));
}

std::vector<double> torus_times(const Family& family, const std::vector<Method>& methods) {
  constexpr int batch = 4096;  // stays in the cache
  stability::Random random(99);
  std::vector<TorusCase> cases;
  for (int i = 0; i < batch; ++i) {
    const stability::Case c = make_case(family, random);
    cases.push_back({std::get<Torus>(c.shape), c.ray});
  }
  std::vector<std::function<bool(const TorusCase&)>> calls;
  for (const Method& method : methods) {
    calls.emplace_back(
        [solve = method.solve](const TorusCase& c) { return solve(c.torus, c.ray).has_value(); });
  }
  return nanoseconds(cases, calls, 31);
}

double shape_time(const Family& family) {
  stability::Random random(99);
  std::vector<stability::Case> cases;
  for (int i = 0; i < 4096; ++i) {
    cases.push_back(make_case(family, random));
  }
  const std::vector<std::function<bool(const stability::Case&)>> calls{
      [](const stability::Case& c) { return stability::own_solver(c.shape, c.ray).has_value(); }};
  return nanoseconds(cases, calls, 15)[0];
}

std::string row(const std::string& name, const std::vector<std::string>& cells) {
  std::string line = "| " + name + " |";
  for (const std::string& cell : cells) {
    line += " " + cell + " |";
  }
  return line + "\n";
}

std::string heading(const std::string& first, const std::vector<std::string>& columns) {
  return row(first, columns) + row("---", std::vector<std::string>(columns.size(), "---"));
}

/// A tally of many rays without what it keeps of each.
Tally lean(Tally tally) {
  tally.relative_t = {};
  return tally;
}

}  // namespace

std::vector<Figures> own_figures(const Options& options) {
  const std::vector<Family> families = stability::families();
  std::vector<Figures> figures(families.size());
  in_parallel(families.size(), options.threads, [&](std::size_t i) {
    Tally tally = run(families[i], stability::own_solver, options.rays, 2024);
    const double t_error = tally.relative_t_at(0.999);
    figures[i] = {families[i], lean(std::move(tally)), t_error};
    const Tally& t = figures[i].tally;
    fmt::print(stderr, "{}: {} rays, {} ({}) missed, {} ({}) false\n", families[i].name(), t.rays,
               t.missed, t.missed_below_resolution, t.false_hits, t.false_below_resolution);
  });
  return figures;
}

std::string circumstances(const Options& options) {
  std::string model = "unknown processor";
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("model name")) {
      model = line.substr(line.find(':') + 2);
      break;
    }
  }
  const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format(
      "{:%Y-%m-%d}, {}, GCC {}. Rays per family: {} for this program, {} for each other torus "
      "method. Times: median of rounds in which the methods take turns, one thread.\n",
      fmt::gmtime(now), model, __VERSION__, options.rays, options.other_rays);
}

std::string torus_tables(const Options& options, const std::vector<Figures>& own) {
  const std::vector<Method> methods = torus_methods();
  std::vector<Family> families;
  std::vector<std::vector<Tally>> tallies;
  for (const Figures& figures : own) {
    if (figures.family.shape == "torus") {
      families.push_back(figures.family);
      tallies.emplace_back(methods.size());
      tallies.back()[0] = figures.tally;
    }
  }
  std::vector<std::string> names;
  for (const Method& method : methods) {
    names.emplace_back(method.name);
  }
  std::string cost = heading("ns per ray", names);
  std::string misses = heading("missed per million", names);
  std::string inventions = heading("false per million", names);
  std::string errors = heading("error / R", names);
  const std::size_t others = methods.size() - 1;
  in_parallel(families.size() * others, options.threads, [&](std::size_t i) {
    const std::size_t m = 1 + i % others;
    const stability::Solver solver = [solve = methods[m].solve](const Shape& s, const Ray& ray) {
      return solve(std::get<Torus>(s), ray);
    };
    tallies[i / others][m] = lean(run(families[i / others], solver, options.other_rays, 2024));
  });
  for (std::size_t f = 0; f < families.size(); ++f) {
    std::vector<std::string> ns, miss, invented, error;
    for (const double t : torus_times(families[f], methods)) {
      ns.push_back(fmt::format("{:.0f}", t));
    }
    for (const Tally& t : tallies[f]) {
      miss.push_back(failures(t.missed, t.missed_below_resolution, t.rays));
      invented.push_back(failures(t.false_hits, t.false_below_resolution, t.rays));
      error.push_back(fmt::format("{:.1e}", t.error));
    }
    const std::string name = families[f].name().substr(7);
    cost += row(name, ns);
    misses += row(name, miss);
    inventions += row(name, invented);
    errors += row(name, error);
  }
  return cost + "\n" + misses + "\n" + inventions + "\n" + errors;
}

std::string shape_table(const std::vector<Figures>& own) {
  std::string out = heading(
      "family", {"rays", "hits", "missed", "false", "error", "point", "normal", "t p99.9", "ns"});
  for (const Figures& figures : own) {
    const Tally& t = figures.tally;
    out += row(figures.family.name(),
               {fmt::format("{:.0e}", static_cast<double>(t.rays)), std::to_string(t.hits),
                failures(t.missed, t.missed_below_resolution, t.rays),
                failures(t.false_hits, t.false_below_resolution, t.rays),
                fmt::format("{:.1e}", t.error), fmt::format("{:.1e}", t.point_error),
                fmt::format("{:.1e}", t.normal_error), fmt::format("{:.1e}", figures.t_error),
                fmt::format("{:.0f}", shape_time(figures.family))});
  }
  return out;
}

std::string leaving_table(const Options& options) {
  struct Named {
    const char* name;
    Policy policy;
    long share;  ///< the others are there to compare with: a hundredth of the rays shows them
  };
  const std::vector<Named> policies{{"side (this program)", Policy::side, 1},
                                    {"touching shape (this program)", Policy::touching, 10},
                                    {"rounding-bound offset", Policy::offset, 100},
                                    {"t > 1e-6", Policy::epsilon, 100}};
  std::string out =
      heading("policy", {"rays", "false", "leaks", "wrong crossing", "below resolution"});
  const auto placements = stability::placements();
  for (const Named& named : policies) {
    const long each = options.secondary / named.share / static_cast<long>(placements.size()) + 1;
    std::vector<stability::LeavingTally> tallies(placements.size());
    in_parallel(placements.size(), options.threads, [&](std::size_t i) {
      tallies[i] = run_leaving(placements[i], named.policy, each, 1000 + i);
      fmt::print(stderr, "{}: placement {} of {}, {} rays, {} wrong\n", named.name, i + 1,
                 placements.size(), tallies[i].rays, tallies[i].failures());
    });
    stability::LeavingTally sum;
    for (const auto& t : tallies) {
      sum.add(t);
    }
    out += row(named.name, {std::to_string(sum.rays), std::to_string(sum.false_hits),
                            std::to_string(sum.leaks), std::to_string(sum.wrong),
                            count_of(sum.below_resolution, sum.rays) + " per million"});
  }
  return out;
}

}  // namespace rt::bench
