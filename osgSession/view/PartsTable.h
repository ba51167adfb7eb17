// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <foundation/Result.h>

namespace trainer
{

/// What one picture cost. Units: ms of the wall clock and of all threads of the process.
struct PictureCost
{
    double wallMs = 0.0, processorMs = 0.0;
    double draws = 0.0;    ///< of OpenGL, without those of shadow maps
    double mapDraws = 0.0; ///< those of shadow maps
};

/// The pictures that were drawn without one part. An empty name: with all parts.
struct PartCosts
{
    std::string without;
    std::vector<PictureCost> pictures;
};

/// Returns a table for people: for each part its medians, p99 and what it costs, which is the median with all
/// less the median without. Rows without pictures are left out. The first row must be that with all parts.
std::string partsText(const std::vector<PartCosts>& parts);

/// Writes the same as JSON: {"parts": [{"without", "pictures", "processorMsP50", "processorMsP99",
/// "wallMsP50", "wallMsP99", "draws", "mapDraws", "costsMs"}, …]}; `costsMs` is processor time. Errors: a
/// file that cannot be written.
foundation::Outcome writeParts(const std::vector<PartCosts>& parts, const std::filesystem::path& file);

} // namespace trainer
