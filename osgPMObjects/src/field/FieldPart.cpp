// SPDX-License-Identifier: Apache-2.0
#include "FieldPart.h"

#include <osg/VertexArrayState>

namespace osgPMObjects
{

FieldPart::FieldPart(std::shared_ptr<const CulledField> culled, const core::FieldBatch& batch,
                     osg::ref_ptr<const FieldMesh> mesh, std::uint32_t group)
    : _culled(std::move(culled)), _batch(batch), _mesh(mesh), _group(group)
{
    setUseDisplayList(false);
    setSupportsDisplayList(false);
    setUseVertexBufferObjects(true);
    setUseVertexArrayObject(false);
    setCullingActive(false); // whoever puts it in has looked
}

void FieldPart::drawImplementation(osg::RenderInfo& renderInfo) const
{
    osg::State& state = *renderInfo.getState();
    osg::GLExtensions& gl = *state.get<osg::GLExtensions>();
    osg::VertexArrayState* const arrays = state.getCurrentVertexArrayState();
    arrays->setVertexBufferObjectSupported(true);
    const bool isSwitching = _batch.pass != core::FieldPass::settled;
    _mesh->arrays(_group, _batch.pass == core::FieldPass::switching)
        .drawVertexArraysImplementation(renderInfo);
    _culled->buffer->use(state, _culled->serial, _culled->drawList.instances);
    for (std::uint32_t i = _batch.firstRun; i < _batch.endRun; ++i)
    {
        const core::FieldRun& run = _culled->drawList.runs[i];
        InstanceBuffer::pointTo(gl, run.first, isSwitching);
        _mesh->draw(state, run.rung, _group, run.count);
    }
    InstanceBuffer::end(gl);
    arrays->unbindVertexBufferObject();
    arrays->unbindElementBufferObject();
}

unsigned int FieldPart::draws() const
{
    unsigned int draws = 0;
    for (std::uint32_t i = _batch.firstRun; i < _batch.endRun; ++i)
        draws += _mesh->hasFaces(_culled->drawList.runs[i].rung, _group);
    return draws;
}

osg::BoundingBox FieldPart::computeBoundingBox() const
{
    const auto& [low, high] = std::tie(_batch.low, _batch.high);
    return {osg::Vec3d(low[0], low[1], low[2]), osg::Vec3d(high[0], high[1], high[2])};
}

} // namespace osgPMObjects
