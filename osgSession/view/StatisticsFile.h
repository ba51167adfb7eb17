// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include "view/FrameStatistics.h"
#include "view/OpeningClock.h"

namespace trainer
{

/// Returns the statistics as JSON text:
///   {"frames": [{"frame", "timeS", "triangles", "splits", "merges", "adaptUs", "cullMs", "drawMs",
///                "maxErrorPx", "wallMs", "processorMs", "uploadBytes", "residentMb"}, …],
///    "summary": {"frames": n, "triangles": {"first", "median", "p99", "max"}, …}}
/// median, p99 and max are those of the frames behind the first.
/// With a scenery each frame has, besides, "objectsVisible", "objectsDrawn", "objectsSwitching",
/// "objectTriangles", "objectCullMs" and "objectMethods": {METHOD: {"objects", "switched", "clamped",
/// "fullArea", "faded", "gone", "triangles"}, …} of those in sight. With stages of the opening, there is
/// "opening": [{"stage", "wallS", "processorS"}, …], in their order. `withTimings` false leaves the measured
/// columns and the stages out: two runs then give the same bytes.
std::string statisticsJson(const std::vector<FrameStatistics>& frames, bool withTimings = true,
                           const std::vector<OpeningStage>& opening = {});

/// Writes statisticsJson() to a file. Errors: the file cannot be written; no partial file remains.
foundation::Outcome writeStatistics(const std::vector<FrameStatistics>& frames,
                                    const std::vector<OpeningStage>& opening,
                                    const std::filesystem::path& file);

} // namespace trainer
