// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include <foundation/Result.h>

#include "worldmaking/map/LandMap.h"
#include "worldmaking/streets/BuildStreets.h"

namespace worldtool
{

/// The ground of elevation data, and the largest rectangle of degrees about its middle that lies within its corners.
struct EarthGround
{
    worldmaking::GroundOnEarth heightM; ///< by latitude and longitude, in the datum of the samples
    worldmaking::MapBounds bounds;
};

/// Loads elevation rasters. Errors: those of importDems(); a raster without georeference.
foundation::Result<EarthGround> loadGround(const std::vector<std::filesystem::path>& dems);

} // namespace worldtool
