// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>

namespace testsupport
{

/// Refines a mesh for a view and checks it by brute force: conforming, nothing open, every sample within the
/// tolerance.
inline testing::AssertionResult isSoundFrom(osgTerrainROAM::core::RoamMesh& mesh,
                                            const viewlod::ViewState& view, double tolerancePx)
{
    mesh.refine(view, {.errorTolerancePx = tolerancePx});
    if (!mesh.tree().isConforming()) return testing::AssertionFailure() << "the mesh does not conform";
    const auto report = osgTerrainROAM::core::checkDrawnMesh(mesh.tile(), mesh.drawn(), &view);
    if (report.tJunctions + report.cracks > 0 || !(report.maxErrorPx <= tolerancePx))
        return testing::AssertionFailure()
               << report.tJunctions << " T-junctions, " << report.cracks << " cracks, " << report.maxErrorPx
               << " px where " << tolerancePx << " are allowed";
    return testing::AssertionSuccess();
}

} // namespace testsupport
