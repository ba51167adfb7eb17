// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include <osgRoads/core/place/PlacedNetwork.h>
#include <osgRoads/core/surface/RoadMesh.h>
#include <osgTerrainROAM/core/features/OpeningCells.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

#include "scenery/roads/DrawnContact.h"
#include "simulation/player/GroundContact.h"
#include "simulation/player/ScenarioPlayer.h"

/// Ground with roads, as the trainer makes it.
struct RoadScene
{
    std::shared_ptr<osgTerrainROAM::core::RoamTile> tile;
    std::shared_ptr<const osgRoads::core::PlacedNetwork> roads;
    osgRoads::core::RoadMesh mesh;
    osgTerrainROAM::core::OpeningCells openings; ///< where no ground is drawn

    simulation::PlayerOptions stage() const;
};

/// A network on made ground, or the terrain of a .roam file; a failed test if it cannot be made.
RoadScene sceneOf(const std::filesystem::path& file);

/// Ground and roads of a test, the ground not cut yet.
RoadScene sceneOf(std::shared_ptr<osgTerrainROAM::core::RoamTile> tile,
                  std::shared_ptr<const osgRoads::core::PlacedNetwork> roads);

/// The drive of `trainer tour`.
simulation::Scenario driveOver(const RoadScene& scene, double durationS);

/// What is checked of a drive.
struct ContactRequest
{
    int everyFrames = 1;       ///< of 24 a second
    double raisedM = 0.0;      ///< added to all heights on which something stands
    std::uint32_t coarser = 0; ///< levels that the roads' chunks are drawn coarser than chosen
};

/// The contacts of a drive, and the worst of them.
struct ContactReport
{
    std::size_t frames = 0, points = 0, broken = 0, undrawn = 0;
    scenery::DrawnContact worstNear, worstFar;
    std::string text() const;
};

/// Plays a drive. In each frame the wheels are compared with what a camera behind the car draws below them, and points up to 800 m
/// ahead in the lane and on both verges with what the driver sees.
ContactReport contactsOf(const RoadScene& scene, simulation::Scenario scenario,
                         const ContactRequest& request);
