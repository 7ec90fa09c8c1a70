// A driver for compilers without libFuzzer: runs each file of a folder, then mutations of them.
//   fuzz_x FOLDER SECONDS [SEED]
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Bytes = std::vector<std::uint8_t>;

std::vector<Bytes> files_of(const std::filesystem::path& folder) {
  std::vector<Bytes> all;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::ifstream in(entry.path(), std::ios::binary);
    all.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return all;
}

/// One of the inputs with a few bytes changed, doubled, cut out, or taken from another.
Bytes mutated(const std::vector<Bytes>& inputs, std::mt19937_64& random) {
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
  Bytes bytes = inputs[below(inputs.size())];
  for (std::size_t changes = 1 + below(6); changes > 0; --changes) {
    const auto at = static_cast<std::ptrdiff_t>(below(bytes.size()));
    const auto length = static_cast<std::ptrdiff_t>(
        std::min<std::size_t>(below(40), bytes.size() - static_cast<std::size_t>(at)));
    const Bytes piece(bytes.begin() + at, bytes.begin() + at + length);
    const Bytes& other = inputs[below(inputs.size())];
    switch (below(5)) {
      case 0:
        bytes.insert(bytes.begin() + at, static_cast<std::uint8_t>(random()));
        break;
      case 1:
        bytes.erase(bytes.begin() + at, bytes.begin() + at + length);
        break;
      case 2:
        bytes.insert(bytes.begin() + at, piece.begin(), piece.end());
        break;
      case 3: {
        const auto from = static_cast<std::ptrdiff_t>(below(other.size()));
        const auto to = static_cast<std::ptrdiff_t>(
            std::min<std::size_t>(static_cast<std::size_t>(from) + 60, other.size()));
        const Bytes taken(other.begin() + from, other.begin() + to);
        bytes.insert(bytes.begin() + at, taken.begin(), taken.end());
        break;
      }
      default:
        if (!bytes.empty()) {
          bytes[static_cast<std::size_t>(at)] ^= static_cast<std::uint8_t>(1u << below(8));
        }
    }
  }
  return bytes;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: %s FOLDER SECONDS [SEED]\n", argv[0]);
    return 2;
  }
  const auto inputs = files_of(std::filesystem::absolute(argv[1]));
  std::mt19937_64 random(argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
  for (const Bytes& bytes : inputs) {
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
  const auto end = std::chrono::steady_clock::now() +
                   std::chrono::duration<double>(std::strtod(argv[2], nullptr));
  const std::string last =
      "/tmp/rt-fuzz-last-" + std::filesystem::path(argv[0]).filename().string();
  std::size_t runs = 0;
  for (; std::chrono::steady_clock::now() < end; ++runs) {
    const Bytes bytes = mutated(inputs, random);
    std::ofstream(last, std::ios::binary)  // what to look at when this one fails
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
  std::fprintf(stderr, "%zu inputs, %zu mutations\n", inputs.size(), runs);
}
