// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <foundation/Heights.h>

#include <osgTerrainROAM/core/features/HoldingPositions.h>

#include "scenery/roads/things/RoadThings.h"

namespace scenery
{

/// The middle of a paved way or of a runway. Frame: the scene's. Units: metres.
struct PavedWay
{
    std::vector<glm::dvec2> middle;
    double widthM = 0.0;
};

/// Places a sign with the runway's designators on both sides of each holding position, towards who waits:
/// 5 m from the taxiway's edge, 11 m where the runway is 1 200 m or longer. None stands on what is paved, off
/// the ground, or within 4 m of another.
/// Source: ICAO Annex 14, 8th edition, 5.4.2 and table 5-5.
roads::RoadThings holdingSigns(std::span<const osgTerrainROAM::core::HoldingPosition> positions,
                               std::span<const PavedWay> paved, const foundation::HeightInPlan& ground);

} // namespace scenery
