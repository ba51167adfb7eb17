// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include <foundation/Result.h>

#include "worldmaking/streets/BuildStreets.h"

namespace worldtool
{

/// Loads elevation rasters and returns their ground by latitude and longitude, in the datum of their samples.
/// Errors: those of importDems(); a raster without georeference.
foundation::Result<worldmaking::GroundOnEarth> loadGround(const std::vector<std::filesystem::path>& dems);

} // namespace worldtool
