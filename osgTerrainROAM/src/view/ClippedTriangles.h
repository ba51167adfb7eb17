// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <osg/PrimitiveSet>
#include <osg/Vec3f>

#include <osgTerrainROAM/core/roam/RoamMesh.h>

namespace osgTerrainROAM
{

/// Triangles of a mesh, cut where the data end, as OSG's functors take them.
/// Frame: the tile's. Units: metres, single precision.
struct ClippedTriangles
{
    std::vector<osg::Vec3f> vertices;
    std::vector<GLuint> indices;

    void accept(osg::PrimitiveFunctor& functor) const;
};

ClippedTriangles clippedTriangles(const core::RoamMesh& mesh, std::span<const core::TriangleRange> ranges);

/// All triangles of the mesh.
ClippedTriangles clippedTriangles(const core::RoamMesh& mesh);

} // namespace osgTerrainROAM
