// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osg/PrimitiveSet>
#include <osg/Vec3f>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>
#include <osgTerrainROAM/core/roam/MeshData.h>

namespace osgTerrainROAM
{

/// The drawn triangles, clipped at the edge of the data, in the form of OSG's functors.
/// Frame: the tile's. Units: metres, single precision.
struct ClippedTriangles
{
    std::vector<osg::Vec3f> vertices;
    std::vector<GLuint> indices;

    void accept(osg::PrimitiveFunctor& functor) const;
};

ClippedTriangles clippedTriangles(const core::PlacedTile& tile, const core::DrawnMesh& mesh);

} // namespace osgTerrainROAM
