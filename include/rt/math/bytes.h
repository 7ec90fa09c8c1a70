#pragma once
/// Values as bytes, and a digest of bytes. In this machine's own order: what is written here is
/// read by the program that wrote it.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "rt/math/hash.h"

namespace rt {

using Bytes = std::span<const unsigned char>;

/// Tells apart files that differ by accident, not by intent: 64 bits.
inline std::uint64_t digest(Bytes bytes, std::uint64_t key = 0) {
  key = combine(key, bytes.size());
  while (!bytes.empty()) {
    std::uint64_t word = 0;
    const std::size_t n = std::min(bytes.size(), sizeof word);
    std::memcpy(&word, bytes.data(), n);
    key = mix64(key ^ word) + golden64;
    bytes = bytes.subspan(n);
  }
  return key;
}

class ByteWriter {
 public:
  template <class T>
  void value(const T& v) {
    list(std::span<const T>(&v, 1));
  }
  /// The items alone; the reader knows their number.
  template <class T>
  void list(std::span<const T> items) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (!items.empty()) {
      const std::size_t before = data_.size();
      data_.resize(before + items.size_bytes());
      std::memcpy(data_.data() + before, items.data(), items.size_bytes());
    }
  }
  void text(std::string_view s) {
    value(std::uint64_t{s.size()});
    list(std::span(s));
  }
  void reserve(std::size_t bytes) { data_.reserve(bytes); }
  Bytes bytes() const { return data_; }
  std::vector<unsigned char> take() { return std::move(data_); }

 private:
  std::vector<unsigned char> data_;
};

/// Reads what a ByteWriter wrote. Throws std::out_of_range where the bytes end too soon.
class ByteReader {
 public:
  explicit ByteReader(Bytes bytes) : rest_(bytes) {}

  template <class T>
  T value() {
    T v;
    list(std::span<T>(&v, 1));
    return v;
  }
  template <class T>
  void list(std::span<T> items) {
    static_assert(std::is_trivially_copyable_v<T>);
    const Bytes from = next(items.size_bytes());
    if (!from.empty()) {
      std::memcpy(items.data(), from.data(), from.size());
    }
  }
  std::string text() {
    const Bytes from = next(value<std::uint64_t>());
    return {from.begin(), from.end()};
  }
  Bytes next(std::uint64_t size) {
    if (size > rest_.size()) {
      throw std::out_of_range("the bytes end too soon");
    }
    const Bytes taken = rest_.first(static_cast<std::size_t>(size));
    rest_ = rest_.subspan(taken.size());
    return taken;
  }
  bool at_end() const { return rest_.empty(); }

 private:
  Bytes rest_;
};

}  // namespace rt
