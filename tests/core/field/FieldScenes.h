// SPDX-License-Identifier: Apache-2.0
// Fields of generated models for tests.
#pragma once

#include <osgPMObjects/core/field/FieldView.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "ClosedMeshes.h"
#include "Random.h"
#include "SelectionScenes.h"

namespace testsupport
{

/// A model with all tables that a field needs.
struct FieldSubject
{
    osgPMObjects::core::Mesh mesh;
    osgPMObjects::core::ProgressiveMesh progressive;
    osgPMObjects::core::LevelTable table;
    osgPMObjects::core::LevelLadder ladder;
    osgPMObjects::core::FacingBins facing;

    explicit FieldSubject(osgPMObjects::core::Mesh given)
        : mesh(std::move(given)),
          progressive(osgPMObjects::core::buildProgressiveMesh(mesh, osgPMObjects::core::simplify(mesh))),
          table(osgPMObjects::core::LevelTable::of(progressive)),
          ladder(osgPMObjects::core::LevelLadder::of(progressive, table)),
          facing(osgPMObjects::core::facingBinsOf(mesh))
    {
    }

    /// A torus of 4800 faces.
    static const FieldSubject& torus()
    {
        static const FieldSubject made(testsupport::torus(60, 40));
        return made;
    }

    osgPMObjects::core::FieldModel model() const
    {
        osgPMObjects::core::FieldModel model;
        model.table = &table;
        model.ladder = &ladder;
        model.facing = &facing;
        double radius = 0.0;
        glm::dvec3 half(0.0);
        for (const glm::dvec3& p : mesh.positions)
        {
            radius = std::max(radius, glm::length(p));
            half = glm::max(half, glm::abs(p));
        }
        model.sphere.radius = radius;
        model.box.halfSizes = half;
        model.switching.method = osgPMObjects::core::SwitchMethod::discrete;
        return model;
    }
};

inline glm::dquat anyTurn(Random& random)
{
    return glm::quat_cast(rotation(random));
}

/// Makes a field of objects of several models, scattered in a flat box about 0.
inline osgPMObjects::core::Field scatteredField(std::vector<osgPMObjects::core::FieldModel> models,
                                                std::uint32_t count, double reachM, std::uint64_t seed = 7)
{
    Random random(seed);
    std::vector<osgPMObjects::core::FieldObject> objects;
    for (std::uint32_t i = 0; i < count; ++i)
        objects.push_back({{between(random, -reachM, reachM), between(random, -reachM, reachM),
                            between(random, 0.0, 0.1 * reachM)},
                           anyTurn(random),
                           between(random, 0.3, 1.5),
                           i % static_cast<std::uint32_t>(models.size()),
                           {}});
    return {std::move(models), std::move(objects)};
}

inline osgPMObjects::core::FieldCamera cameraFrom(const viewlod::ViewState& view, std::uint64_t frame,
                                                  float stepS = 0.04f)
{
    osgPMObjects::core::FieldCamera camera;
    camera.view = osgPMObjects::core::SelectionView::from(view);
    camera.eye = view.eyeWorld;
    camera.frustum = view.frustum;
    camera.frame = frame;
    camera.stepS = stepS;
    return camera;
}

} // namespace testsupport
