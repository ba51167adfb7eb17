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

/// The model of an entity: the file that its `model3d` names, else a built-in model by its category, else a box of
/// its size. Frame: the entity's own, placed by show(). Threads: show() between frames.
class EntityModel
{
public:
    /// `folder`: model3d is relative to it. Errors: a model file that exists and cannot be read.
    static foundation::Result<EntityModel> create(const simulation::ScenarioObject& object,
                                                  const std::filesystem::path& folder);

    osg::Node* node() const { return _car ? _car->node() : _placed.get(); }
    void show(const simulation::EntityState& state);

    /// Returns a note when another model is drawn than asked for, else an empty text.
    const std::string& note() const { return _note; }

private:
    std::string _note;
    std::shared_ptr<scenery::CarModel> _car; ///< has wheels to move; else
    osg::ref_ptr<osg::MatrixTransform> _placed;
};

} // namespace trainer
