// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <osgTerrainROAM/core/bisection/BisectionMesh.h>

namespace osgTerrainROAM::core
{

/// A surface, the TINs in its triangles, and its bounds: what the meshes of all eyes share.
/// Threads: any; it does not change.
struct BisectionModel
{
    /// `patches`: as for BisectionMesh.
    BisectionModel(BisectionSurface made, std::vector<BisectionPatch> tins)
        : surface(std::move(made)), patches(std::move(tins)), bounds(surface, patches)
    {
    }
    BisectionModel(const BisectionModel&) = delete;
    BisectionModel& operator=(const BisectionModel&) = delete;

    BisectionSurface surface;
    std::vector<BisectionPatch> patches;
    BisectionBounds bounds;
};

} // namespace osgTerrainROAM::core
