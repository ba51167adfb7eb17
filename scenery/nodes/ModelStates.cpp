// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/ModelStates.h"

#include <osg/AlphaFunc>
#include <osg/CullFace>

#include <osgPMObjects/ExportNode>

#include "scenery/models/paint/MipChain.h"
#include "scenery/nodes/ObjectShading.h"
#include "scenery/nodes/PaintedTexture.h"
#include "scenery/nodes/SurfaceState.h"

namespace scenery
{

namespace
{

Finish finishOf(models::Coat coat)
{
    switch (coat)
    {
    case models::Coat::lacquered:
        return Finish::lacquered;
    case models::Coat::foliage:
        return Finish::foliage;
    case models::Coat::lit:
        return Finish::lit;
    case models::Coat::matt:
        break;
    }
    return Finish::matt;
}

} // namespace

osg::ref_ptr<osg::StateSet> surfaceState(const models::Surface& surface, osg::Texture2D* texture)
{
    const osg::ref_ptr<osg::Group> carrier = new osg::Group;
    setObjectShading(*carrier, finishOf(surface.coat));
    const osg::ref_ptr<osg::StateSet> state = carrier->getOrCreateStateSet();
    state->setTextureAttributeAndModes(0, texture);
    if (surface.coat == models::Coat::foliage)
        state->setAttributeAndModes(new osg::AlphaFunc(osg::AlphaFunc::GREATER,
                                                       static_cast<float>(models::kAlphaThreshold) / 255.0F));
    else
    {
        state->getUniform("objectTintMask")->set(1.0F);
        state->setAttributeAndModes(new osg::CullFace(osg::CullFace::BACK));
    }
    return state;
}

osg::ref_ptr<osg::Texture2D> ModelStates::textureOf(const models::Surface& surface)
{
    osg::ref_ptr<osg::Texture2D>& texture = _textures[{surface.painting, surface.look}];
    const bool isFoliage = surface.coat == models::Coat::foliage;
    if (!texture) texture = paintedTexture(surface.painting, isFoliage, 4.0F, surface.look.get());
    return texture;
}

osg::ref_ptr<osg::StateSet> ModelStates::stateOf(const models::Surface& surface)
{
    osg::ref_ptr<osg::StateSet>& state = _states[{surface.painting, surface.coat, surface.look}];
    if (!state) state = surfaceState(surface, textureOf(surface));
    return state;
}

std::vector<osg::ref_ptr<osg::StateSet>> ModelStates::statesOf(const models::Model& model)
{
    std::vector<osg::ref_ptr<osg::StateSet>> states;
    for (const models::Surface& surface : model.surfaces)
        states.push_back(stateOf(surface));
    return states;
}

osg::ref_ptr<osg::Group> makeModelNode(const models::Model& model, ModelStates& states)
{
    return osgPMObjects::exportNode(model.mesh, states.statesOf(model));
}

} // namespace scenery
