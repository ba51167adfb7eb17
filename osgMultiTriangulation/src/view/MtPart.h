// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <osgTerrainROAM/core/roam/RoamTile.h>

#include <osgTraversal/CulledPart>

#include "MtViewTable.h"

namespace osgMultiTriangulation
{

/// The cells of a surface that one camera sees in one frame.
class MtPart : public osgTraversal::CulledPart
{
public:
    MtPart(MtAnswer answer, std::vector<std::uint32_t> cells, double vertexStep,
           std::shared_ptr<const osgTerrainROAM::core::RoamTile> tile, const osg::BoundingBox& bounds);

    void drawImplementation(osg::RenderInfo& renderInfo) const override;

    using CulledPart::accept;
    void accept(osg::PrimitiveFunctor& functor) const override;

protected:
    ~MtPart() override = default;

private:
    MtAnswer _answer;
    std::vector<std::uint32_t> _cells;
    double _vertexStep;
    std::shared_ptr<const osgTerrainROAM::core::RoamTile> _tile;
};

/// Shows the triangles of cells to a functor, in single precision, as OSG's functors have it.
void showCells(const core::DrawnSurface& surface, const std::vector<std::uint32_t>& cells, double vertexStep,
               osg::PrimitiveFunctor& functor);

} // namespace osgMultiTriangulation
