// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osg/Group>

#include <osgTerrainROAM/Atmosphere>

#include "EntityModel.h"
#include "SceneTerrain.h"
#include "simulation/player/ScenarioPlayer.h"

namespace trainer
{

/// The scene graph of a scenario: terrain, sky, atmosphere and one model for each entity.
/// Frame: world, the scene's east-north-up. Threads: show() between frames.
class ScenarioScene
{
public:
    /// `folder`: the scenario's. Errors: as EntityModel.
    static foundation::Result<ScenarioScene> create(const simulation::Scenario& scenario,
                                                    const SceneTerrain& terrain,
                                                    const std::filesystem::path& folder);

    osg::Group& root() { return *_root; }

    /// Returns one line for each model that differs from the one asked for.
    std::vector<std::string> notes() const;

    /// Sets entities, sun and atmosphere to the state of the player.
    void show(const simulation::ScenarioPlayer& player);

    /// Hides an entity: the one whose camera is used.
    void hide(std::size_t entity) { _entities[entity].node()->setNodeMask(0); }

private:
    ScenarioScene();

    osg::ref_ptr<osg::Group> _root;
    osg::ref_ptr<osgTerrainROAM::Atmosphere> _atmosphere;
    std::vector<EntityModel> _entities; ///< in the order of Scenario::entities
};

} // namespace trainer
