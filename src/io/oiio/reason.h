#pragma once
#include <OpenImageIO/imageio.h>

#include <exception>
#include <string>

namespace rt::io {

inline std::string reason_of(const std::string& reason) {
  return reason.empty() ? "OpenImageIO gave no reason" : reason;
}

/// What `function` returns, or what it threw: exceptions stay in the module.
template <typename F>
std::string guarded(F function) {
  try {
    OIIO::attribute("debug", 0);  // Debian's build chats on standard error otherwise
    return function();
  } catch (const std::exception& error) {
    return reason_of(error.what());
  }
}

}  // namespace rt::io
