// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <osgTerrainROAM/core/features/HoldingPositions.h>

#include "RunwayFrame.h"

namespace osgTerrainROAM::core
{

/// Returns the holding positions of one taxiway, given by its middle (holdingPositions()).
std::vector<HoldingPosition> holdingPositionsAlong(const std::vector<glm::dvec2>& path, double widthM,
                                                   std::span<const RunwayFrame> runways);

} // namespace osgTerrainROAM::core
