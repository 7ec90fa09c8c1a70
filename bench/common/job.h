#pragma once
/// What the programs of bench/ that render share.
#include <cstdint>
#include <string>
#include <vector>

#include "rt/scene/render_job.h"

namespace rt::bench {

/// The job of a script's first gr.render.
RenderJob first_job(const std::string& script, const std::vector<std::string>& arguments = {});

/// OPTION=VALUE or FEATURE=off, as the command line and --disable have them.
void set(RenderOptions& options, const std::string& word);

/// Processor seconds of this thread, to the nanosecond.
double thread_seconds();

/// Bytes that are allocated at the moment.
std::uint64_t allocated();

}  // namespace rt::bench
