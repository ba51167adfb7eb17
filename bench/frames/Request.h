// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <foundation/Result.h>
#include <nlohmann/json.hpp>

#include <osgTerrainROAM/core/roam/RoamTile.h>

#include <osgOffscreen/OffscreenContext>
#include <osgTerrainROAM/TerrainMaterial>

#include "Stage.h"
#include "measurement/flights/SteadyFlight.h"

namespace framebench
{

/// What the command line asks for, and the terrain it is asked of.
struct Request
{
    std::string dem;
    std::vector<int> crop;
    measurement::SteadyFlight flight;
    osgOffscreen::OffscreenSettings picture{osgOffscreen::defaultBackend(), 1280, 720, 0};
    int frames = 60;
    std::vector<double> tolerancesPx{1.0, 0.5};
    std::filesystem::path jsonFile;

    int tileCells = 128; ///< database only

    std::vector<std::string> antialiasing{"none", "msaa4", "ssaa2", "ssaa4"}; ///< pop only, as the next three
    int coarseFrame = -1; ///< a frame that is refined to a tenth of the detail: the measure has to see it
    std::filesystem::path pictureFolder;
    int pictureFrame = -1;

    std::shared_ptr<const osgTerrainROAM::core::RoamTile> tile;
    osg::ref_ptr<osgTerrainROAM::TerrainMaterial> material;

    Eye eye(int frame) const
    {
        const double aspect = static_cast<double>(picture.widthPx) / picture.heightPx;
        return {flight.view(tile->tile, frame), flight.projection(aspect)};
    }
};

using Report = nlohmann::ordered_json;

/// Milliseconds a frame of each way to draw the terrain, frame by frame in turn along the flight.
/// Errors: no such graphics context.
foundation::Result<Report> measureFrames(const Request& request);

/// Milliseconds a frame of a database of osgTerrain tiles: osgTerrain's GeometryTechnique and ours, in turn along the flight.
/// Errors: no such graphics context; tiles that the square does not divide into.
foundation::Result<Report> measureDatabase(const Request& request);

/// How much the pictures' distance from those of the full mesh changes from frame to frame.
/// Errors: no such graphics context; pictures that cannot be written.
foundation::Result<Report> measurePop(const Request& request);

} // namespace framebench
