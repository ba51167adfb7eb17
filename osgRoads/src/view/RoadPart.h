// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <osgRoads/core/surface/RoadView.h>

#include <osgTraversal/CulledPart>

#include "RoadBuffers.h"

namespace osgRoads
{

/// Which strips of the surface are drawn.
enum class RoadStrips
{
    all,
    paved,
    ground, ///< core::isGround()
};

/// Returns the ranges of the chosen levels; none is empty.
std::vector<RoadRange> rangesOf(const core::RoadMesh& mesh, const std::vector<core::ChunkChoice>& choices,
                                RoadStrips strips);

/// The chunks that one camera sees, at its levels.
class RoadPart : public osgTraversal::CulledPart
{
public:
    RoadPart(std::shared_ptr<RoadBuffers> buffers, std::vector<RoadRange> ranges,
             const core::RoadViewSettings& settings, double pixelsPerTangent, const osg::BoundingBox& bounds);

    void drawImplementation(osg::RenderInfo& renderInfo) const override;

    using CulledPart::accept;
    void accept(osg::PrimitiveFunctor& functor) const override;

protected:
    ~RoadPart() override = default;

private:
    void setUniforms(osg::State& state) const;

    std::shared_ptr<RoadBuffers> _buffers;
    std::vector<RoadRange> _ranges;
    core::RoadViewSettings _settings;
    double _pixelsPerTangent;
};

/// Shows the triangles of ranges to a functor (statistics, intersection), in the scene's frame.
void showTriangles(const core::PagedRoadMesh& mesh, const std::vector<RoadRange>& ranges,
                   osg::PrimitiveFunctor& functor);

} // namespace osgRoads
