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

/// The values of the command line, and the terrain.
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
    int coarseFrame = -1; ///< a frame refined ten times coarser, which the measurement must detect
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

/// Measures milliseconds a frame of each way to draw the terrain, in turns along the flight. Errors: no such
/// graphics context.
foundation::Result<Report> measureFrames(const Request& request);

/// Measures milliseconds a frame of a database of osgTerrain tiles with the GeometryTechnique of osgTerrain
/// and with ours, in turns along the flight. Errors: no such graphics context; tiles that do not divide the
/// square.
foundation::Result<Report> measureDatabase(const Request& request);

/// Measures how much the difference from the images of the full mesh changes between frames. Errors: no such
/// graphics context; images that cannot be written.
foundation::Result<Report> measurePop(const Request& request);

} // namespace framebench
