/// compare_images A B: exit code 0 when the pictures are near enough, 1 when not, 2 when that could
/// not be found out.
#include <charconv>
#include <cmath>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "compare.h"

namespace {

constexpr const char* usage =
    "usage: compare_images A B [--max M] [--mean M] [--count N --above D]\n"
    "Prints how far two pictures are apart; exit code 0 near enough, 1 not, 2 unreadable.\n"
    "  --max M    no value differs by more than M (0..1)\n"
    "  --mean M   the mean of all differences is at most M\n"
    "  --count N  at most N pixels differ by more than D of --above (default 0)\n"
    "Without any of these the pictures must be equal.\n";

double parse_number(std::string_view option, const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value) ||
      value < 0.0) {
    throw std::invalid_argument(std::string(option) + " takes a number from 0, not '" + text + "'");
  }
  return value;
}

struct Request {
  std::vector<std::string> files;
  rt::images::Tolerance tolerance;
};

Request parse(const std::vector<std::string>& arguments) {
  Request request;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& option = arguments[i];
    if (!option.starts_with("--")) {
      request.files.push_back(option);
      continue;
    }
    if (i + 1 == arguments.size()) {
      throw std::invalid_argument(option + " takes a number");
    }
    const double value = parse_number(option, arguments[++i]);
    if (option == "--max") {
      request.tolerance.max = value;
    } else if (option == "--mean") {
      request.tolerance.mean = value;
    } else if (option == "--count") {
      request.tolerance.count = static_cast<std::size_t>(value);
    } else if (option == "--above") {
      request.tolerance.above = value;
    } else {
      throw std::invalid_argument("unknown option " + option);
    }
  }
  if (request.files.size() != 2) {
    throw std::invalid_argument("two pictures are needed");
  }
  return request;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Request request = parse({argv + 1, argv + argc});
    const auto verdict =
        rt::images::compare(rt::io::read_image(request.files[0]),
                            rt::io::read_image(request.files[1]), request.tolerance);
    std::printf("%s\n", verdict.text.c_str());
    return verdict.near_enough ? 0 : 1;
  } catch (const std::invalid_argument& error) {
    std::fprintf(stderr, "compare_images: %s\n%s", error.what(), usage);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "compare_images: %s\n", error.what());
  }
  return 2;
}
