// SPDX-License-Identifier: Apache-2.0
#include "pmtool/ArrangementOptions.h"

#include <algorithm>
#include <iostream>
#include <string>

#include "pmtool/MeasureCache.h"
#include "terminal/CommandLine.h"

namespace pmtool
{

using osgPMObjects::core::ArrangementSettings;

void addArrangementOptions(CLI::App& command, ArrangementRequest& request)
{
    ArrangementSettings& settings = request.settings;
    command
        .add_option_function<std::string>(
            "--fifo",
            [&request](const std::string& size)
            {
                request.measuresCache = size == "measure";
                if (!request.measuresCache)
                    request.settings.cacheSize = static_cast<std::uint32_t>(std::stoul(size));
            },
            "vertices that the cache holds (16); measure: as many as this machine's does")
        ->check(CLI::IsMember({"measure"}) | CLI::Range(3, 1024));
    command
        .add_option("--tswap-step", settings.tswapStep,
                    "tswap: share of the faces that is removed between two orderings (0.2)")
        ->check(terminal::between(0.001, 1.0));
    command
        .add_option("--stay-weight", settings.stayWeight,
                    "tswap: weight of a face that stays, in transformed vertices (1)")
        ->check(terminal::between(0.0, 3.0));
    command
        .add_option("--line-weight", settings.touchedLineWeight,
                    "tswap: weight of a face in a cache line that is written anyway, likewise (0.25)")
        ->check(terminal::between(0.0, 3.0));
    command
        .add_option("--look-ahead", settings.lookAhead,
                    "tswap: faces that are tried before one is chosen (1)")
        ->check(terminal::between(1, ArrangementSettings::kMostLookAhead));
    command
        .add_option("--window-blocks", settings.windowBlocks,
                    "ours: blocks of faces that become one less at a time (3)")
        ->check(terminal::between(2, ArrangementSettings::kMostWindowBlocks));
    command
        .add_option("--block-faces", settings.blockFaces,
                    "blocks, ours: faces of a block (0: 32 for blocks, 1024 to 3072 for ours)")
        ->check(terminal::between(0, ArrangementSettings::kMostBlockFaces));
}

foundation::Result<ArrangementSettings> arrangementSettingsOf(const ArrangementRequest& request)
{
    ArrangementSettings settings = request.settings;
    if (!request.measuresCache) return settings;
    const auto measured = measureVertexCache();
    if (!measured) return measured.error();
    std::cout << "vertex cache: " << *measured << " vertices\n";
    settings.cacheSize = std::clamp(*measured, 3u, ArrangementSettings::kMostCacheSize);
    return settings;
}

} // namespace pmtool
