// --report: a page with everything in it.
#include "program.h"

namespace rt::test {
namespace {

using Report = ProgramTest;

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t n = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    ++n;
  }
  return n;
}

std::string decoded(const std::string& text) {
  static const std::string digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  unsigned word = 0;
  int bits = 0;
  for (const char c : text.substr(0, text.find('='))) {
    word = word << 6 | static_cast<unsigned>(digits.find(c));
    bits += 6;
    if (bits >= 8) {
      bits -= 8;
      out += static_cast<char>(word >> bits & 255u);
    }
  }
  return out;
}

TEST_F(Report, HoldsPictureAndMapsAndNeedsNothingBesideIt) {
  ASSERT_EQ(run_script(sphere_script(), "--report page.html").exit_code, 0);
  const std::string page = contents(folder_ / "page.html");
  const std::string start = "src=\"data:image/png;base64,";
  EXPECT_EQ(count(page, "<img "), 3u);
  EXPECT_EQ(count(page, start), 3u);
  EXPECT_EQ(page.find("http"), std::string::npos);
  const std::size_t at = page.find(start) + start.size();
  const std::string png = decoded(page.substr(at, page.find('"', at) - at));
  EXPECT_TRUE(png.starts_with("\x89PNG\r\n\x1a\n"));
  EXPECT_EQ(png.substr(png.size() - 8, 4), "IEND");
  EXPECT_EQ(page.find("width=\"24\" height=\"16\"") != std::string::npos, true);
  for (const char* word : {"tracing", "max_error", "Rays", "<td>camera</td>", "<pre>"}) {
    EXPECT_NE(page.find(word), std::string::npos) << word;
  }
}

TEST_F(Report, DoesNotChangeThePicture) {
  ASSERT_EQ(run_script(sphere_script(), "-o a.png").exit_code, 0);
  ASSERT_EQ(run_script(sphere_script(), "-o b.png --report page.html").exit_code, 0);
  EXPECT_TRUE(same_file(folder_ / "a.png", folder_ / "b.png"));
}

TEST_F(Report, SaysWhyThereAreNoMaps) {
  ASSERT_EQ(run_script(sphere_script(), "--samples 4 --report page.html").exit_code, 0);
  const std::string page = contents(folder_ / "page.html");
  EXPECT_EQ(count(page, "<img "), 1u);
  EXPECT_NE(page.find("no error was estimated"), std::string::npos);
}

TEST_F(Report, ShowsEveryPictureOfAScriptAndEscapesNames) {
  const std::string script = sphere_script("for i = 1, 2 do") + "end\n";
  write("a&b<c.lua", script);
  ASSERT_EQ(run("'a&b<c.lua' -o x.png --report page.html").exit_code, 0);
  const std::string page = contents(folder_ / "page.html");
  EXPECT_EQ(count(page, "<section>"), 2u);
  EXPECT_NE(page.find("a&amp;b&lt;c.lua"), std::string::npos);
  EXPECT_EQ(page.find("b<c"), std::string::npos);
}

TEST_F(Report, RefusesAPlaceThatIsNoneBeforeItRenders) {
  const Outcome o = run_script(sphere_script(), "--report nowhere/page.html");
  EXPECT_EQ(o.exit_code, 3);
  EXPECT_NE(o.err.find("there is no folder nowhere"), std::string::npos) << o.err;
  EXPECT_FALSE(left_a_file());
}

}  // namespace
}  // namespace rt::test
