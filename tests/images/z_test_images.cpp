/// z_test_images PICTURE MEAN VARIANCE COUNT: exit code 0 when the picture is a fair draw, 1 when
/// not, 2 when that could not be found out.
/// z_test_images --make MEAN VARIANCE PICTURE...: makes the reference.
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "z_test.h"

namespace {

using rt::io::read_image;

void make(const std::vector<std::string>& words) {
  std::vector<rt::io::Image> pictures;
  for (std::size_t i = 3; i < words.size(); ++i) {
    pictures.push_back(read_image(words[i]));
  }
  const auto reference = rt::images::reference_of(pictures);
  rt::io::write_image(words[1], reference.mean, rt::Encoding::raw, {});
  rt::io::write_image(words[2], reference.variance, rt::Encoding::raw, {});
}

int run(const std::vector<std::string>& words) {
  if (words.size() > 3 && words[0] == "--make") {
    make(words);
    return 0;
  }
  if (words.size() != 4) {
    throw std::invalid_argument("z_test_images [--make] ...: see its first lines");
  }
  const auto verdict = rt::images::z_test(
      read_image(words[0]), {read_image(words[1]), read_image(words[2])}, std::stoi(words[3]));
  std::printf("%s", verdict.text.c_str());
  return verdict.fair ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "z_test_images: %s\n", error.what());
    return 2;
  }
}
