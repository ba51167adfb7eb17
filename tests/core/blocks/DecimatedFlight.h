// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/blocks/DecimatedMesh.h>
#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>

namespace osgTerrainROAM::core
{

/// Spoils measured errors: tests prove with it that a bound which is too small is found.
struct BlockErrorsMutation
{
    static void scale(BlockErrors& errors, float factor)
    {
        for (auto* metres : {&errors._blocksM, &errors._stripsM, &errors._morphedM})
            for (float& m : *metres)
                m *= factor;
    }

    /// Lets every border with a coarser neighbour pass for exact.
    static void forgetStrips(BlockErrors& errors)
    {
        for (float& m : errors._stripsM)
            m = 0.0f;
    }
};

} // namespace osgTerrainROAM::core

namespace testsupport
{

/// What the brute-force check says of a mesh as a whole.
inline testing::AssertionResult isSound(const osgTerrainROAM::core::TerrainMesh& mesh,
                                        const viewlod::ViewState& view, double tolerancePx)
{
    if (!mesh.isValid()) return testing::AssertionFailure() << "the mesh is not valid";
    const auto report = osgTerrainROAM::core::checkDrawnMesh(mesh.tile(), mesh.drawn(), &view);
    if (report.tJunctions + report.cracks > 0 || !(report.maxErrorPx <= tolerancePx))
        return testing::AssertionFailure()
               << report.tJunctions << " T-junctions, " << report.cracks << " cracks, " << report.maxErrorPx
               << " px where " << tolerancePx << " are allowed";
    return testing::AssertionSuccess() << report.maxErrorPx << " px";
}

} // namespace testsupport
