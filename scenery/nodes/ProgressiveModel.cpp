// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/ProgressiveModel.h"

#include <utility>

#include <foundation/ForEachAtOnce.h>

#include <osg/Matrixd>
#include <osg/Texture>

#include <osgPMObjects/core/simplify/Simplifiable.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "scenery/nodes/ModelStates.h"

namespace scenery
{

namespace core = osgPMObjects::core;

core::ProgressiveMesh progressiveOf(core::Mesh mesh)
{
    core::makeSimplifiable(mesh);
    const core::CollapseSequence sequence = core::simplify(mesh);
    core::ArrangementSettings settings;
    settings.arrangement = core::Arrangement::plain; // fields have index lists of their own
    return core::buildProgressiveMesh(mesh, sequence, settings);
}

namespace
{

void useIsotropicTextures(const std::vector<osg::ref_ptr<osg::StateSet>>& states)
{
    for (const osg::ref_ptr<osg::StateSet>& state : states)
        if (auto* const texture =
                dynamic_cast<osg::Texture*>(state->getTextureAttribute(0, osg::StateAttribute::TEXTURE)))
            texture->setMaxAnisotropy(1.0F);
}

} // namespace

std::vector<osg::ref_ptr<const osgPMObjects::ProgressiveShape>>
makeProgressiveModels(std::vector<models::Model> models)
{
    ModelStates states; // paints, in one thread
    std::vector<std::vector<osg::ref_ptr<osg::StateSet>>> statesOf;
    for (const models::Model& model : models)
    {
        statesOf.push_back(states.statesOf(model));
        useIsotropicTextures(statesOf.back());
    }
    std::vector<osg::ref_ptr<const osgPMObjects::ProgressiveShape>> shapes(models.size());
    foundation::forEachAtOnce(models.size(),
                              [&](std::size_t i)
                              {
                                  shapes[i] = new osgPMObjects::ProgressiveShape(
                                      progressiveOf(std::move(models[i].mesh)), std::move(statesOf[i]));
                              });
    return shapes;
}

osg::Quat attitudeOf(const glm::dmat3& axes)
{
    // Columns of GLM are rows of OSG.
    return osg::Matrixd(axes[0].x, axes[0].y, axes[0].z, 0.0, axes[1].x, axes[1].y, axes[1].z, 0.0, axes[2].x,
                        axes[2].y, axes[2].z, 0.0, 0.0, 0.0, 0.0, 1.0)
        .getRotate();
}

} // namespace scenery
