#include "rt/cli/checkpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "rt/math/bytes.h"
#include "rt/scene/error.h"

namespace rt::cli {
namespace {

/// Changes whenever the layout does.
constexpr std::string_view magic = "raytracer checkpoint 1\n";

void put(ByteWriter& out, const Facts& facts) {
  out.value(std::uint64_t{facts.size()});
  for (const Fact& fact : facts) {
    out.text(fact.name);
    out.text(fact.value);
  }
}

Facts facts_from(ByteReader& in) {
  Facts facts;
  for (auto left = in.value<std::uint64_t>(); left > 0; --left) {
    std::string name = in.text();
    facts.push_back({std::move(name), in.text()});
  }
  return facts;
}

Checkpoint decode(ByteReader in) {
  Checkpoint checkpoint;
  in.next(magic.size());
  checkpoint.run = facts_from(in);
  for (auto left = in.value<std::uint64_t>(); left > 0; --left) {
    Checkpoint::Finished& f = checkpoint.finished.emplace_back();
    f.picture = in.text();
    f.options = facts_from(in);
    f.digest = in.value<std::uint64_t>();
  }
  if (in.value<std::uint8_t>() != 0) {
    checkpoint.current.emplace();
    checkpoint.current->picture = in.text();
    checkpoint.current->options = facts_from(in);
    const Bytes state = in.next(in.value<std::uint64_t>());
    checkpoint.state.assign(state.begin(), state.end());
  }
  if (!in.at_end()) {
    throw std::out_of_range("more than a checkpoint");
  }
  return checkpoint;
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why) {
  throw FileError(fmt::format("cannot resume from {}: {}; without --resume all begins anew",
                              file.string(), why));
}

}  // namespace

std::vector<unsigned char> encode(const Checkpoint& checkpoint, const Rendering* rendering) {
  ByteWriter out;
  out.list(std::span(magic));
  put(out, checkpoint.run);
  out.value(std::uint64_t{checkpoint.finished.size()});
  for (const Checkpoint::Finished& f : checkpoint.finished) {
    out.text(f.picture);
    put(out, f.options);
    out.value(f.digest);
  }
  out.value(std::uint8_t{checkpoint.current && rendering != nullptr});
  if (checkpoint.current && rendering != nullptr) {
    out.text(checkpoint.current->picture);
    put(out, checkpoint.current->options);
    out.value(std::uint64_t{rendering->state_bytes()});
    rendering->save(out);
  }
  out.value(digest(out.bytes()));
  return out.take();
}

Checkpoint read_checkpoint(const std::filesystem::path& file) {
  std::error_code error;
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in || !std::filesystem::is_regular_file(file, error)) {
    refuse(file, errno != 0 ? std::generic_category().message(errno) : "it is no regular file");
  }
  std::vector<unsigned char> bytes(
      static_cast<std::size_t>(std::filesystem::file_size(file, error)));
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!in) {
    refuse(file, "it could not be read");
  }
  const Bytes all(bytes);
  if (all.size() < magic.size() ||
      !std::equal(magic.begin(), magic.end(), all.begin(),
                  [](char a, unsigned char b) { return static_cast<unsigned char>(a) == b; })) {
    refuse(file, "it is no checkpoint of this program, or of another version");
  }
  const std::size_t trailer = sizeof(std::uint64_t);
  if (all.size() < magic.size() + trailer || ByteReader(all.last(trailer)).value<std::uint64_t>() !=
                                                 digest(all.first(all.size() - trailer))) {
    refuse(file, "it is damaged (its checksum is wrong)");
  }
  try {
    return decode(ByteReader(all.first(all.size() - trailer)));
  } catch (const std::exception&) {
    refuse(file, "it is damaged");
  }
}

}  // namespace rt::cli
