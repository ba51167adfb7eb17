// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <osg/Drawable>

#include <osgTerrainROAM/core/roam/RoamTile.h>

#include "MtViewTable.h"

namespace osgMultiTriangulation
{

/// The drawable that one cull traversal puts into the render graph: the cells of a surface that one camera sees in one frame.
/// It never changes, so a frame may be culled while the last is drawn.
class MtPart : public osg::Drawable
{
public:
    MtPart(MtAnswer answer, std::vector<std::uint32_t> cells, double vertexStep,
           std::shared_ptr<const osgTerrainROAM::core::RoamTile> tile, const osg::BoundingBox& bounds);

    void drawImplementation(osg::RenderInfo& renderInfo) const override;
    osg::BoundingBox computeBoundingBox() const override { return _bounds; }

    using osg::Drawable::accept;
    bool supports(const osg::PrimitiveFunctor&) const override { return true; }
    void accept(osg::PrimitiveFunctor& functor) const override;

protected:
    ~MtPart() override = default;

private:
    MtAnswer _answer;
    std::vector<std::uint32_t> _cells;
    double _vertexStep;
    std::shared_ptr<const osgTerrainROAM::core::RoamTile> _tile;
    osg::BoundingBox _bounds;
};

/// Shows the triangles of cells to a functor, in single precision, as OSG's functors have it.
void showCells(const core::DrawnSurface& surface, const std::vector<std::uint32_t>& cells, double vertexStep,
               osg::PrimitiveFunctor& functor);

} // namespace osgMultiTriangulation
