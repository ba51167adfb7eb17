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

/// One measurement: a driver on a path; no driver: refinement from scratch.
struct BenchRun
{
    std::string dem;
    osgTerrainROAM::core::SplitBounds bounds; ///< of the tile, with or without patches
    std::optional<osgTerrainROAM::core::Driver> driver;
    osgTerrainROAM::core::LeafPlacement placement = osgTerrainROAM::core::LeafPlacement::inOrder;
    measurement::Path path = measurement::Path::flight;
    double tolerancePx = 1.0;
    bool centrePixels = false; ///< the tolerance holds in the middle of the image only
    int frames = measurement::BenchmarkFlight::kFrames;
    int framesBetweenChecks = 120; ///< 1: every frame is checked by brute force

    std::string driverName() const;
    viewlod::ViewState view(int frame) const;
};

/// Receives the triangles of a frame, positions in the tile's frame.
using FrameSink = std::function<foundation::Outcome(int frame, const viewlod::ViewState&,
                                                    const osgTerrainROAM::core::DrawnMesh&)>;

/// Flies the path, measures each frame but the first, which builds the mesh, and checks some frames by brute
/// force. `sink` receives the checked frames. Returns the row of the table: times in microseconds of this
/// thread, changes in diamonds split or merged, upload in bytes per triangle that was added or removed.
foundation::Result<nlohmann::ordered_json> measure(const BenchRun& run, const FrameSink& sink);

} // namespace terraintool
