// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <osgRoads/core/place/PlacedNetwork.h>
#include <osgRoads/core/surface/RoadMesh.h>
#include <osgTerrainROAM/core/features/OpeningCells.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>
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

/// One camera, whose mesh of the ground follows it, as the trainer refines it.
class DrawnWatcher
{
public:
    DrawnWatcher(const RoadScene& scene, const ContactRequest& request);

    /// Refines ground and roads for a view of 40° and 960 by 540 pixels.
    void look(const glm::dvec3& eye, const glm::dvec3& at);

    /// Compares a place with what is drawn there, if it is in the image.
    void check(const glm::dvec3& place, ContactReport& report) const;

private:
    const RoadScene& _scene;
    const ContactRequest _request;
    osgTerrainROAM::core::RoamMesh _ground;
    std::optional<scenery::DrawnScene> _drawn;
};

/// Plays a drive. In each frame the wheels are compared with what a camera behind the car draws below them,
/// and points up to 800 m ahead in the lane and on both verges with what the driver sees.
ContactReport contactsOf(const RoadScene& scene, simulation::Scenario scenario,
                         const ContactRequest& request);
