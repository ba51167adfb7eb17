// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include <foundation/Result.h>

#include "worldmaking/land/CoverRaster.h"
#include "worldtool/Commands.h"
#include "worldtool/EarthGround.h"

namespace worldtool
{

/// The class of the land at a place, degrees east and north; none where the raster says nothing, and in
/// settlements and water, which maps know better.
using CoverOnEarth = std::function<worldmaking::Cover(const glm::dvec2& degrees)>;

/// Reads the land-cover raster of a request; an empty function where it names none. Errors: those of
/// readCoverTable() and importCover().
foundation::Result<CoverOnEarth> coverOf(const Request& request, const EarthGround& ground);

} // namespace worldtool
