// SPDX-License-Identifier: Apache-2.0
#include "ViewPart.h"

#include <osgTerrainROAM/TileUniforms>

#include "ClippedTriangles.h"
#include "FixedFunction.h"

namespace osgTerrainROAM
{

ViewPart::ViewPart(std::shared_ptr<ViewGroup> group, ViewAnswer answer, const viewlod::Frustum& frustum,
                   const osg::BoundingBox& bounds)
    : CulledPart(bounds), _group(std::move(group)), _answer(std::move(answer)), _frustum(frustum)
{
}

void ViewPart::drawImplementation(osg::RenderInfo& renderInfo) const
{
    osg::State& state = *renderInfo.getState();
    const core::TileFrame& frame = _group->tile().frame();
    setTileUniforms(state, frame, frame.vertexStepM());
    setColourWhite(state);
    _group->draw(state, _answer, _frustum);
}

void ViewPart::accept(osg::PrimitiveFunctor& functor) const
{
    ClippedTriangles triangles;
    _group->visitMesh(_answer, _frustum,
                      [&](const core::TerrainMesh& mesh, const std::vector<core::IndexRange>& ranges)
                      { triangles = clippedTriangles(mesh.tile().tile, mesh.drawn(ranges)); });
    triangles.accept(functor);
}

} // namespace osgTerrainROAM
