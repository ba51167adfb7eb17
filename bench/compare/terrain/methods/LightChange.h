// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgTerrainROAM/core/roam/MeshData.h>

namespace terraintool
{

/// How the light would jump between the meshes of two frames, were they lit by normals of their vertices, as
/// in the paper. (Here they are lit by a map of all samples, which no change of the mesh touches.)
struct LightChange
{
    double turnedPercent =
        0.0; ///< of the vertices that both have: those whose normal turns by more than kSeenDeg
    double largestDeg = 0.0; ///< the largest turn
};

/// A turn of a normal that changes its brightness by up to a tenth.
inline constexpr double kSeenDeg = 6.0;

/// Compares the normals of vertices, the means of those of the triangles around them by area, at the places
/// that both meshes have.
LightChange lightChangeBetween(const osgTerrainROAM::core::DrawnMesh& before,
                               const osgTerrainROAM::core::DrawnMesh& now);

} // namespace terraintool
