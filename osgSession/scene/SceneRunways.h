// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/RoamFile.h>
#include <osgTerrainROAM/core/features/HoldingPositions.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

#include "request/PlayRequest.h"

namespace trainer
{

/// A runway that a world has. Frame: the scene's.
struct SceneRunway
{
    StripRequest strip;      ///< in the direction in which the map has it
    std::string designators; ///< "03/21": the first in that direction; empty: unknown
    bool isPaved = true;
};

/// A taxiway: its middle line. Frame: the scene's. Units: metres.
struct SceneTaxiway
{
    std::vector<glm::dvec2> middle;
    double widthM = 15.0;
};

/// The runways of a world, the taxiways between them, and where one waits on these.
struct SceneAirfields
{
    std::vector<SceneRunway> runways;
    std::vector<SceneTaxiway> taxiways;
    std::vector<osgTerrainROAM::core::HoldingPosition> holds;
};

/// Returns the runways among the features that a .roam file names, in their order, the paved
/// taxiways that begin or end at a runway or at another taxiway, and the holding positions. Errors: as
/// importFeatures().
foundation::Result<SceneAirfields> sceneAirfields(const osgTerrainROAM::core::RoamFile& description,
                                                  const osgTerrainROAM::core::RoamTile& tile);

/// Returns runways and paved taxiways as bytes, for sceneAirfieldsIn().
std::string bytesOf(const SceneAirfields& airfields);

/// Absent: bytesOf() did not write them.
std::optional<SceneAirfields> sceneAirfieldsIn(std::string_view bytes);

/// Returns the strip to take off from and land on: the longest paved runway, or the longest where none is
/// paved, in the direction against the wind. Nothing: there is none. `windFromDeg`: from north, clockwise;
/// absent: calm.
std::optional<StripRequest> runwayInUse(const std::vector<SceneRunway>& runways,
                                        const std::optional<double>& windFromDeg);

} // namespace trainer
