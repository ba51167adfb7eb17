// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include <foundation/Result.h>

#include <osg/Node>
#include <osg/ref_ptr>

#include <osgTerrainROAM/core/heightfield/DemImport.h>

#include <osgTerrainROAM/RoamTerrain>

#include "simulation/player/SceneFrame.h"

namespace trainer
{

/// The ground that a scenario plays on.
struct SceneTerrain
{
    osg::ref_ptr<osg::Node> node;                      ///< what is drawn
    osg::ref_ptr<osgTerrainROAM::RoamTerrain> terrain; ///< within it; null when the scene has no ROAM terrain

    /// Of the scene's frame; absent without georeference.
    std::optional<simulation::Geodetic> origin() const;

    /// The true surface; empty when there is none to ask. `terrain` must outlive it.
    simulation::GroundProvider ground() const;
};

/// Opens a .roam file or an elevation raster with the terrain library itself, so that errors keep their words; `terrain`
/// is never null. Errors: as makeTerrain().
foundation::Result<SceneTerrain> openElevation(const std::filesystem::path& file,
                                               const osgTerrainROAM::core::DemImportOptions& import);

/// Opens terrain as openElevation() does, any other file through osgDB, and what osgDB does not read as a raster after
/// all. Errors: no such file, no reader, nothing in it.
foundation::Result<SceneTerrain> openScene(const std::filesystem::path& file,
                                           const osgTerrainROAM::core::DemImportOptions& import);

} // namespace trainer
