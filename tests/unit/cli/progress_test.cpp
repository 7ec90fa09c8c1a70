#include "rt/cli/progress.h"

#include <gtest/gtest.h>

#include <thread>

namespace rt::cli {
namespace {

TEST(ProgressReport, CountsTheTimeOfEarlierRuns) {
  testing::internal::CaptureStderr();
  ProgressReport report(ProgressStyle::json, false, "a.png", 5000.0);
  std::this_thread::sleep_for(std::chrono::milliseconds(110));  // it speaks every tenth of a second
  Progress progress{};
  progress.fraction = 0.5;
  report(progress);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("\"seconds\": 500"), std::string::npos) << said;
}

}  // namespace
}  // namespace rt::cli
