#include "rt/cli/report.h"

#include <gtest/gtest.h>

namespace rt::cli {
namespace {

PictureReport traced_in(double seconds) {
  PictureReport report;
  report.picture = "a.png";
  report.crop = {0, 0, 20, 10};
  report.statistics.samples = 800;
  report.statistics.rays.camera = 4'000'000;
  report.phases.trace = seconds;
  return report;
}

TEST(Summary, SaysSamplesTimeAndRate) {
  EXPECT_EQ(summary(traced_in(2.0)),
            "a.png: 20x10, 4 samples a pixel, 2.00 s, 4.00 M rays (2.0 M/s)");
}

TEST(Summary, HasNoRateWhereTheClockHasNotTicked) {
  EXPECT_EQ(summary(traced_in(0.0)),
            "a.png: 20x10, 4 samples a pixel, 0.00 s, 4.00 M rays (0.0 M/s)");
}

}  // namespace
}  // namespace rt::cli
