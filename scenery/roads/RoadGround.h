// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <osgRoads/core/network/RoadNetwork.h>
#include <osgTerrainROAM/core/heightfield/HeightField.h>

#include "scenery/roads/PlaceRoads.h"

namespace scenery
{

/// Ground for a network without a terrain: a plane tile around it whose heights follow the roads.
/// Frame of the scene: x and y of the file less those of the field's south-western sample, so that a network
/// far from its origin is as exact as one at it. Units: metres.
struct RoadGround
{
    osgTerrainROAM::core::HeightField field;
    glm::dvec2 cornerM{0.0};  ///< the south-western sample, in the file's frame
    double roadSampleM = 0.0; ///< between the samples that cutRoads() is to add beside the roads
    SceneRoads roads;
};

/// Makes the ground of a network: 1000 samples or fewer along a side, kLeastSpacingM apart or more, with a
/// margin of 600 m. Heights between roads are interpolated, coarsely where roads are far (cutRoads() fits
/// them to the roads exactly).
/// Errors: those of readNetwork().
/// Source: Gortler, Grzeszczuk, Szeliski & Cohen, *The Lumigraph*, 1996, section 3.4 (pull-push).
foundation::Result<RoadGround> makeRoadGround(const std::filesystem::path& file);

inline constexpr double kLeastSpacingM = 8.0;

/// Returns how far apart samples beside the roads are: 2 m, twice as much for networks of more than 300 km,
/// and so on, so that their number stays bounded.
double roadSampleM(const osgRoads::core::RoadNetwork& network);

} // namespace scenery
