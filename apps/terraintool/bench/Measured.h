// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <viewlod/Slice.h>

#include <osgTerrainROAM/core/roam/MeshData.h>
#include <osgTerrainROAM/core/roam/Outline.h>
#include <osgTerrainROAM/core/roam/PatchShape.h>
#include <osgTerrainROAM/core/roam/SplitBounds.h>

namespace terraintool
{

/// Measures some work in microseconds of this thread, so that other work on the machine does not count.
template<class Work>
double microsecondsOf(const Work& work)
{
    const double begin = viewlod::Slice::threadUs();
    work();
    return viewlod::Slice::threadUs() - begin;
}

/// Makes a mesh without slots of leaves of the bintree: every leaf, or its patch, with vertices of its own.
inline osgTerrainROAM::core::DrawnMesh
meshOfLeaves(const osgTerrainROAM::core::SplitBounds& bounds,
             const std::vector<osgTerrainROAM::core::GridTriangle>& leaves)
{
    using namespace osgTerrainROAM::core;
    const PlacedTile& tile = bounds.tile().tile;
    DrawnMesh mesh;
    for (const GridTriangle& t : leaves)
        if (isDrawn(tile, t)) PatchShape::of(bounds.patchExponent()).append(tile, t, mesh);
    return mesh;
}

} // namespace terraintool
