// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include <foundation/Heights.h>
#include <foundation/Result.h>
#include <glm/glm.hpp>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

#include "worldmaking/map/LandMap.h"
#include "worldmaking/streets/BuildStreets.h"

namespace worldtool
{

/// The ground of elevation data, and the rectangle of degrees around its corners; there need not be ground
/// everywhere in it.
struct EarthGround
{
    /// by latitude and longitude, in the datum of the samples; nothing within 5 m of the data's edge
    foundation::HeightOnEarth heightM;
    worldmaking::MapBounds bounds;
    std::shared_ptr<const osgTerrainROAM::core::PlacedTile> tile;
    /// Where the ground is in the scene that shows the data: metres east and north of their middle, and up.
    std::function<glm::dvec3(const glm::dvec2& degrees)> placeInScene;
};

/// Loads elevation rasters. Errors: those of importDems(); a raster without georeference.
foundation::Result<EarthGround> loadGround(const std::vector<std::filesystem::path>& dems);

} // namespace worldtool
