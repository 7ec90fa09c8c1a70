#pragma once
#include <cstdio>
#include <string>

namespace rt::cli {

/// A line on standard error. That nobody can read it (a closed pipe, a full disk) ends nothing.
inline void say(const std::string& line) { std::fputs((line + '\n').c_str(), stderr); }

inline void warn(const std::string& text) { say("warning: " + text); }

}  // namespace rt::cli
