#pragma once
#include <filesystem>
#include <string>

namespace rt::cli {

/// The frames of an animation, both ends included: the script runs once for each, with its number
/// in the global `frame`.
struct Frames {
  int first = 0;
  int last = 0;
};

/// Of the text "A..B" (--frames) or "N" (--frame): whole numbers from 0 to 999999, A not above B.
/// Throws UsageError, which names the option.
Frames parse_frames(const std::string& text);
Frames parse_frame(const std::string& text);

/// The name of a frame's picture: out.png becomes out_0007.png. Left as it is where it ends with
/// the frame's number already (out7.png, out-0007.png), as scripts may name it.
std::filesystem::path frame_path(const std::filesystem::path& picture, int frame);

}  // namespace rt::cli
