// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osg/MatrixTransform>

#include "scenery/nodes/EntityNode.h"
#include "simulation/scenario/Entity.h"
#include "simulation/state/EntityState.h"

namespace trainer
{

/// The model of an entity: the file that its `model3d` names, else a generated model by its category, names
/// and size (scenery/nodes/EntityLook.h). A file `.json` is the look of a generated vehicle. Frame: the
/// entity's own, placed by show(). Threads: show() between frames.
class EntityModel
{
public:
    /// `folder`: model3d is relative to it. `shapes`: of all entities. Errors: a model file that exists and
    /// cannot be read.
    static foundation::Result<EntityModel> create(const simulation::ScenarioObject& object,
                                                  const std::filesystem::path& folder,
                                                  scenery::EntityShapes& shapes);

    osg::Node* node() const { return _generated ? _generated->node() : _placed.get(); }

    /// Its shadow on the ground, which stands beside node(); null: it casts none, as models that were read.
    osg::Node* shadow() const { return _generated ? _generated->shadow() : nullptr; }

    /// Does not draw it any more, but for its shadow: the eye is in it; or draws it again.
    void hide(bool isHidden = true) { _isHidden = isHidden; }

    /// The light in which entities are seen.
    struct Light
    {
        glm::dvec3 sun{0.0, 0.0, 1.0}; ///< towards it, unit vector
        bool isDark = false;           ///< head lamps are on
        double timeS = 0.0;            ///< by which lamps flash
        double mapsReachM = 0.0;       ///< shadow maps show what moves as far from the eye; 0: there are none
        std::optional<glm::dvec3> eye{}; ///< of the last picture; absent: none was drawn
    };

    /// `ground`: onto which it casts its shadow; may be empty.
    void show(const simulation::EntityState& state, const Light& light,
              const simulation::GroundProvider& ground);

    /// Returns the eye of the driver, rider, walker or pilot. Frame: the entity's.
    const glm::dvec3& eye() const { return _eye; }

    /// As what it is generated, or would be in place of a model that was read: its interior fits it.
    const scenery::models::EntityShape& shape() const { return _shape; }

    /// Which lamps the last show() has lit.
    const scenery::models::LitLamps& litLamps() const { return _lit; }

    /// Where its lamps are; none of a model that was read. Frame: the entity's.
    const std::vector<scenery::models::EntityLamp>& lamps() const
    {
        static const std::vector<scenery::models::EntityLamp> kNone;
        return _generated ? _generated->lamps() : kNone;
    }

    /// Returns what is drawn other than asked for, one line each.
    const std::vector<std::string>& notes() const { return _notes; }

private:
    std::vector<std::string> _notes;
    bool _isHidden = false;
    glm::dvec3 _eye{0.0};
    scenery::models::EntityShape _shape;
    scenery::models::LitLamps _lit{};
    std::shared_ptr<scenery::EntityNode> _generated; ///< has parts that move; else
    osg::ref_ptr<osg::MatrixTransform> _placed;
    bool _flies = false; ///< it is generated as an aircraft
};

} // namespace trainer
