// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <foundation/Result.h>

#include <osg/MatrixTransform>

#include "scenery/nodes/CarModel.h"
#include "simulation/player/EntityState.h"
#include "simulation/scenario/Entity.h"

namespace trainer
{

/// What an entity looks like: the file that its `model3d` names, else a model of the program by its category, a box of
/// its size at last. Frame: the entity's own, placed by show(). Threads: show() between frames.
class EntityModel
{
public:
    /// `folder`: what model3d is relative to. Errors: a model file that is there but cannot be read.
    static foundation::Result<EntityModel> create(const simulation::ScenarioObject& object,
                                                  const std::filesystem::path& folder);

    osg::Node* node() const { return _car ? _car->node() : _placed.get(); }
    void show(const simulation::EntityState& state);

    /// What was drawn instead of what was asked for; empty: nothing.
    const std::string& note() const { return _note; }

private:
    std::string _note;
    std::shared_ptr<scenery::CarModel> _car; ///< has wheels to move; else
    osg::ref_ptr<osg::MatrixTransform> _placed;
};

} // namespace trainer
