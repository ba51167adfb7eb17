// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osg/Node>
#include <osg/ref_ptr>

#include <osgRoads/core/place/PlacedNetwork.h>

#include <osgMultiTriangulation/MtDrawable>
#include <osgPMObjects/ProgressiveField>
#include <osgTerrainROAM/RoamTerrain>

#include "SceneRunways.h"
#include "request/PlayRequest.h"
#include "scenery/nodes/AirfieldNode.h"
#include "scenery/nodes/RoadThingsNode.h"
#include "scenery/nodes/SettlementLights.h"
#include "scenery/placement/SkyOccluders.h"
#include "simulation/contact/ObstacleMap.h"
#include "simulation/environment/CloudLayer.h"
#include "simulation/player/SceneFrame.h"
#include "simulation/state/EnvironmentState.h"

namespace trainer
{

/// A part of what stands in a world.
struct StandingPart
{
    const char* name;
    osg::ref_ptr<osg::Node> node;
    osg::ref_ptr<osgPMObjects::ProgressiveField> field = nullptr; ///< null: it has no levels
    osgPMObjects::core::SceneBudgetSettings fullBudget{};         ///< of the field, whatever the quality
    scenery::SkyOccluders occluders{}; ///< what of it hides the sky from the ground
};

/// The terrain of a scenario.
struct SceneTerrain
{
    osg::ref_ptr<osg::Node> node;                      ///< the scene
    osg::ref_ptr<osgTerrainROAM::RoamTerrain> terrain; ///< within it; null when the scene has no ROAM terrain
    std::shared_ptr<const osgRoads::core::PlacedNetwork> roads; ///< null: none
    std::filesystem::path roadsFile{};                          ///< what they were read of
    std::shared_ptr<scenery::RoadThingsNode> roadThings =
        nullptr;                        ///< switches traffic lights; null without roads
    std::optional<double> seaLevelM{};  ///< z of the sea at the scene's origin; absent: not known
    glm::dvec2 cornerM{0.0};            ///< of the terrain's frame in that of the scene
    std::vector<SceneRunway> runways{}; ///< those of its maps
    std::vector<glm::dvec2> houses{};   ///< of its maps, where people live or work
    std::vector<StandingPart> standing{};
    simulation::WorldAir air{};                                       ///< as the world file has it
    std::optional<double> moonlight{};                                ///< the same
    std::optional<std::vector<simulation::CloudLayer>> clouds{};      ///< the same
    std::shared_ptr<scenery::AirfieldNode> airfield = nullptr;        ///< lights and windsocks; null: none
    std::shared_ptr<scenery::SettlementLights> settlements = nullptr; ///< lamps and windows; null: none
    osg::ref_ptr<osgMultiTriangulation::MtDrawable> triangulation =
        nullptr;                      ///< draws the ground instead of the ROAM terrain; null: none
    std::vector<std::string> notes{}; ///< what is not as it was asked for, one line each

    /// What of its map and beside its roads vehicles may hit, in the scene's frame; null: nothing, or
    /// TerrainRequest::wantsObstacles was not set.
    std::shared_ptr<const simulation::ObstacleMap> obstacles = nullptr;

    /// Returns the origin of the scene's frame; absent without georeference.
    std::optional<simulation::Geodetic> origin() const;

    /// Returns the true surface, roads included; empty when the scene has none. `terrain` must outlive it.
    simulation::GroundProvider ground() const;
};

/// Moves a scene so that the origin of its terrain's frame lies at a place. Units: metres.
SceneTerrain moved(SceneTerrain scene, const glm::dvec2& corner);

/// Tells what the head of a file says against openElevation(): a fraction of a second. Errors: those of
/// describeTerrain() and checkDems(); a network or multi-triangulation that cannot be read.
foundation::Outcome checkElevation(const std::filesystem::path& file, const TerrainRequest& request);

/// The same before openScene(), which tells itself of models. Errors: as checkElevation().
foundation::Outcome checkScene(const std::filesystem::path& file, const TerrainRequest& request);

/// Opens a .roam file, with its roads, an elevation raster, a multi-triangulation (.mt) or an OpenDRIVE
/// network (.xodr); `terrain` is never null. Errors: as makeTerrainWithRoads(), openMultiTriangulation() and
/// openNetwork().
foundation::Result<SceneTerrain> openElevation(const std::filesystem::path& file,
                                               const TerrainRequest& request);

/// Opens a terrain as openElevation() does and any other file with osgDB; a file that osgDB cannot read is
/// tried as a raster. Errors: no such file, no reader, an empty scene.
foundation::Result<SceneTerrain> openScene(const std::filesystem::path& file, const TerrainRequest& request);

} // namespace trainer
