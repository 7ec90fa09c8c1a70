#pragma once
#include <atomic>
#include <cstddef>
#include <memory>
#include <utility>

namespace rt::lua {

/// Counts what a script takes of memory and refuses what goes over the limit: what its Lua state
/// allocates (LuaMemory), and what the objects made by gr take beside it (Charge).
class MemoryMeter {
 public:
  explicit MemoryMeter(std::size_t limit) : limit_(limit) {}

  std::size_t limit() const { return limit_; }
  std::size_t left() const {
    const std::size_t used = lua_ + objects_.load(std::memory_order_relaxed);
    return used < limit_ ? limit_ - used : 0;
  }

  bool take(std::size_t bytes) {
    if (bytes > left()) {
      return false;
    }
    objects_.fetch_add(bytes, std::memory_order_relaxed);
    return true;
  }
  void give_back(std::size_t bytes) { objects_.fetch_sub(bytes, std::memory_order_relaxed); }

  /// Called by the script's thread alone.
  void lua_takes(std::size_t bytes) { lua_ += bytes; }
  void lua_gives_back(std::size_t bytes) { lua_ -= bytes; }

 private:
  std::size_t limit_;
  std::size_t lua_ = 0;
  std::atomic<std::size_t> objects_{0};  // a snapshot's meshes may be released on another thread
};

/// A share of the meter, given back when it goes. It keeps the meter alive: a RenderJob may outlive
/// its script.
class Charge {
 public:
  Charge() = default;
  explicit Charge(std::shared_ptr<MemoryMeter> meter) : meter_(std::move(meter)) {}
  Charge(Charge&& other) noexcept
      : meter_(std::move(other.meter_)), bytes_(std::exchange(other.bytes_, 0)) {}
  Charge& operator=(Charge&&) = delete;
  ~Charge() {
    if (bytes_ > 0) {
      meter_->give_back(bytes_);
    }
  }

  bool grow(std::size_t bytes) {
    if (!meter_->take(bytes)) {
      return false;
    }
    bytes_ += bytes;
    return true;
  }

 private:
  std::shared_ptr<MemoryMeter> meter_;
  std::size_t bytes_ = 0;
};

}  // namespace rt::lua
