#pragma once
/// --report: one page that needs nothing beside it. Of each picture: itself, where it errs and
/// where its samples went, how long each phase took, and how it was rendered.
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "rt/cli/report.h"
#include "rt/render/render.h"

namespace rt::cli {

class HtmlReport {
 public:
  /// Throws FileError when no file can be there. Does nothing for an empty path.
  explicit HtmlReport(std::filesystem::path file);

  /// Whether a page is wanted; else the functions below do nothing.
  bool wanted() const { return !file_.empty(); }

  /// A picture is rendered: keeps a copy of it, and its plan as explain() puts it.
  void picture(std::string explained, const RenderResult& result);
  /// It is written too, and all its times are known: encodes it for the page.
  void finish(const PictureReport& report);

  /// Writes the page. Throws FileError.
  void write(const std::filesystem::path& scene) const;

 private:
  std::filesystem::path file_;
  std::optional<RenderResult> result_;  ///< of the picture at hand
  std::string explained_;
  std::string sections_;  ///< of the finished pictures
};

/// How an estimated error shows: white at the target, bluer for each halving below it, redder for
/// each doubling above it, saturated four doublings away. Linear values of what is displayed.
Rgb error_colour(double error, double target);
/// How a count shows: from dark to light by its logarithm between the least and the most.
Rgb count_colour(double count, double least, double most);

/// RFC 4648, section 4.
std::string base64(std::span<const unsigned char> bytes);

}  // namespace rt::cli
