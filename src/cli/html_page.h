#pragma once
/// HTML for html_report.cpp: nothing that is loaded from anywhere.
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rt/cli/report.h"

namespace rt::cli {

std::string html_escaped(std::string_view text);
/// Two columns, names and values; escaped here.
std::string html_table(const std::vector<std::pair<std::string, std::string>>& rows);
/// Seconds by the clock with bars.
std::string phases_table(const Phases& phases);
std::string rays_table(const RenderStatistics& statistics);
/// The whole page about a scene; `body` is HTML.
std::string html_page(const std::string& scene, const std::string& body);

}  // namespace rt::cli
