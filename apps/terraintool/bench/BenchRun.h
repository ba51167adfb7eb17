// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <foundation/Result.h>
#include <nlohmann/json.hpp>

#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "measurement/flights/BenchmarkFlight.h"

namespace terraintool
{

/// One measurement: a driver on a path. No driver: refinement from scratch.
struct BenchRun
{
    std::string dem;
    osgTerrainROAM::core::SplitBounds bounds; ///< of the tile, with or without patches
    std::optional<osgTerrainROAM::core::Driver> driver;
    osgTerrainROAM::core::LeafPlacement placement = osgTerrainROAM::core::LeafPlacement::inOrder;
    measurement::Path path = measurement::Path::flight;
    double tolerancePx = 1.0;
    bool centrePixels = false; ///< the tolerance holds in the picture's middle only, as others measure
    int frames = measurement::BenchmarkFlight::kFrames;
    int framesBetweenChecks = 120; ///< 1: every frame is checked by brute force

    std::string driverName() const;
    viewlod::ViewState view(int frame) const;
};

/// Sees the triangles of a frame, positions in the tile's frame.
using FrameSink = std::function<foundation::Outcome(int frame, const viewlod::ViewState&,
                                                    const osgTerrainROAM::core::DrawnMesh&)>;

/// Flies the path and measures each frame but the first, which builds the mesh; checks some of the frames by brute force.
/// `sink`: is given those frames, too. Returns the row of the table: times in microseconds of this thread, changes in
/// diamonds split or merged, upload in bytes per triangle that came or went.
foundation::Result<nlohmann::ordered_json> measure(const BenchRun& run, const FrameSink& sink);

} // namespace terraintool
