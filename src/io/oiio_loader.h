#pragma once
#include "oiio/table.h"

namespace rt::io {

/// Begins to load rt_oiio.so on a thread of its own; later calls do nothing.
void begin_loading_oiio();

/// Waits for a loading that has begun.
void end_loading_oiio();

/// The module's functions; waits for the loading, which it begins if nobody has. Throws FileError.
const OiioTable& oiio();

}  // namespace rt::io
