// SPDX-License-Identifier: Apache-2.0
#include "MtPart.h"

#include <osgTerrainROAM/TileUniforms>

namespace osgMultiTriangulation
{

MtPart::MtPart(MtAnswer answer, std::vector<std::uint32_t> cells, double vertexStep,
               std::shared_ptr<const osgTerrainROAM::core::RoamTile> tile, const osg::BoundingBox& bounds)
    : CulledPart(bounds),
      _answer(std::move(answer)),
      _cells(std::move(cells)),
      _vertexStep(vertexStep),
      _tile(std::move(tile))
{
}

void MtPart::drawImplementation(osg::RenderInfo& renderInfo) const
{
    osg::State& state = *renderInfo.getState();
    osgTerrainROAM::setTileUniforms(state, _tile->tile.frame(), _vertexStep);
    _answer.buffers->draw(state, *_answer.surface, _cells);
}

void MtPart::accept(osg::PrimitiveFunctor& functor) const
{
    showCells(*_answer.surface, _cells, _vertexStep, functor);
}

void showCells(const core::DrawnSurface& surface, const std::vector<std::uint32_t>& cells, double vertexStep,
               osg::PrimitiveFunctor& functor)
{
    std::vector<osg::Vec3f> places;
    for (const std::uint32_t number : cells)
    {
        const core::DrawnSurface::Cell& cell = surface.cells[number];
        for (std::uint32_t t = cell.firstTriangle; t < cell.firstTriangle + cell.triangles; ++t)
            for (const std::uint32_t corner : surface.triangles[t])
            {
                const core::DrawnSurface::Vertex& v = surface.vertices[corner];
                places.emplace_back(static_cast<float>(v[0] * vertexStep),
                                    static_cast<float>(v[1] * vertexStep),
                                    static_cast<float>(v[2] * vertexStep));
            }
    }
    if (places.empty()) return;
    functor.setVertexArray(static_cast<unsigned int>(places.size()), places.data());
    functor.drawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(places.size()));
}

} // namespace osgMultiTriangulation
