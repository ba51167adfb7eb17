// SPDX-License-Identifier: Apache-2.0
#include "GroupPart.h"

#include <osg/VertexArrayState>

namespace osgPMObjects
{

GroupPart::GroupPart(osg::ref_ptr<const ProgressiveShape> shape, std::uint32_t group, MorphArraysPtr morph)
    : _shape(shape), _group(group), _morph(std::move(morph))
{
    setUseDisplayList(false);
    setSupportsDisplayList(false);
    setUseVertexBufferObjects(true);
    setUseVertexArrayObject(false);
    setDataVariance(osg::Object::STATIC);
    setCullingActive(false); // cull has tested the object already
}

void GroupPart::drawImplementation(osg::RenderInfo& renderInfo) const
{
    osg::State& state = *renderInfo.getState();
    osg::VertexArrayState* const arrays = state.getCurrentVertexArrayState();
    arrays->setVertexBufferObjectSupported(true);
    if (_morph)
        _morph->set(renderInfo, _group);
    else
        _shape->groups()[_group].arrays->drawVertexArraysImplementation(renderInfo);
    drawFaces(state);
    if (_morph) MorphArrays::unset(state);
    arrays->unbindVertexBufferObject();
    arrays->unbindElementBufferObject();
}

osg::BoundingBox GroupPart::computeBoundingBox() const
{
    return _shape->groups()[_group].box;
}

} // namespace osgPMObjects
