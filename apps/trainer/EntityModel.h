// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <foundation/Result.h>

#include <osg/MatrixTransform>

#include "scenery/nodes/EntityNode.h"
#include "simulation/player/EntityState.h"
#include "simulation/scenario/Entity.h"

namespace trainer
{

/// The model of an entity: the file that its `model3d` names, else a generated model by its category, names and size
/// (scenery/nodes/EntityLook.h). Frame: the entity's own, placed by show(). Threads: show() between frames.
class EntityModel
{
public:
    /// `folder`: model3d is relative to it. `shapes`: of all entities. Errors: a model file that exists and cannot be
    /// read.
    static foundation::Result<EntityModel> create(const simulation::ScenarioObject& object,
                                                  const std::filesystem::path& folder,
                                                  scenery::EntityShapes& shapes);

    osg::Node* node() const { return _generated ? _generated->node() : _placed.get(); }

    /// Does not draw it any more: the eye is in it; or draws it again.
    void hide(bool isHidden = true) { _isHidden = isHidden; }

    /// `isDark`: head lamps are on.
    void show(const simulation::EntityState& state, bool isDark);

    /// Returns the eye of the driver, rider, walker or pilot. Frame: the entity's.
    const glm::dvec3& eye() const { return _eye; }

    /// Returns a note when another model is drawn than asked for, else an empty text.
    const std::string& note() const { return _note; }

private:
    std::string _note;
    bool _isHidden = false;
    glm::dvec3 _eye{0.0};
    std::shared_ptr<scenery::EntityNode> _generated; ///< has parts that move; else
    osg::ref_ptr<osg::MatrixTransform> _placed;
    osg::ref_ptr<osg::Group> _aircraft; ///< below it; null: it is none
};

} // namespace trainer
