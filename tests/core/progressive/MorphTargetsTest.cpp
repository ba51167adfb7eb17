// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <gtest/gtest.h>

#include <osgPMObjects/core/progressive/LevelMesh.h>
#include <osgPMObjects/core/progressive/MorphTargets.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "ClosedMeshes.h"
#include "SimplifyMeshes.h"

namespace
{

using namespace osgPMObjects::core;

/// A sheet with a seam, and a torus of another material.
const ProgressiveMesh& morphed()
{
    static const ProgressiveMesh made = []
    {
        const Mesh mesh = testsupport::together(testsupport::texturedInHalves(14, 11),
                                                testsupport::torus(12, 8), {20.0, 0.0, 0.0});
        const CollapseSequence sequence = simplify(mesh);
        return buildProgressiveMesh(mesh, sequence);
    }();
    return made;
}

struct Corners
{
    Triangle wedges, positions;
    auto operator<=>(const Corners&) const = default;
};

Corners sorted(Corners corners)
{
    while (corners.wedges[0] != *std::min_element(corners.wedges.begin(), corners.wedges.end()))
    {
        std::rotate(corners.wedges.begin(), corners.wedges.begin() + 1, corners.wedges.end());
        std::rotate(corners.positions.begin(), corners.positions.begin() + 1, corners.positions.end());
    }
    return corners;
}

/// Returns the faces with area after all wedges have moved to their targets.
std::vector<Corners> facesAt(std::uint32_t steps, const MorphTargets& morph)
{
    const ProgressiveMesh& progressive = morphed();
    ProgressiveLevel level(progressive);
    level.moveTo(steps);
    std::vector<Corners> faces;
    forEachDrawnFace(progressive, level,
                     [&](const Triangle& face, std::uint32_t)
                     {
                         Corners corners{face, face};
                         for (int i = 0; i < 3; ++i)
                         {
                             MorphTargets::Target target{face[i], face[i]};
                             if (face[i] >= morph.firstWedge)
                                 target = morph.targets.at(face[i] - morph.firstWedge);
                             corners.wedges[i] = target.attributeWedge;
                             corners.positions[i] = progressive.mesh.wedgePositions[target.positionWedge];
                         }
                         if (!repeatsCorner(corners.positions)) faces.push_back(sorted(corners));
                     });
    std::sort(faces.begin(), faces.end());
    return faces;
}

TEST(MorphTargets, LeaveTheFacesOfTheCoarserLevelWithTheirWedges)
{
    const std::uint32_t most = morphed().stepCount;
    for (std::uint32_t finer = 0; finer <= most; finer += 7)
        for (std::uint32_t coarser = finer; coarser <= most; coarser += 11)
        {
            const MorphTargets morph = morphTargets(morphed(), finer, coarser);
            EXPECT_EQ(morph.firstWedge + morph.targets.size(), morphed().wedgesAfter(finer));
            const MorphTargets none{morphed().wedgesAfter(coarser), {}};
            ASSERT_EQ(facesAt(finer, morph), facesAt(coarser, none)) << finer << " to " << coarser;
        }
}

TEST(MorphTargets, AreThoseOfOneStepByHand)
{
    const ProgressiveMesh& progressive = morphed();
    const MorphTargets morph = morphTargets(progressive, 0, 1);
    ASSERT_FALSE(morph.targets.empty());
    for (std::uint32_t i = 0; i < morph.targets.size(); ++i)
    {
        const std::uint32_t wedge = morph.firstWedge + i;
        EXPECT_EQ(morph.targets[i].attributeWedge, progressive.parents[wedge]);
        EXPECT_LT(morph.targets[i].attributeWedge, morph.firstWedge);
    }
    EXPECT_TRUE(morphTargets(progressive, 5, 5).targets.empty());
}

/// All wedges of a position move to one position, so that seams do not tear.
TEST(MorphTargets, AreAtOnePlaceForAllWedgesOfAPosition)
{
    const auto& positions = morphed().mesh.wedgePositions;
    const MorphTargets morph = morphTargets(morphed(), 0, morphed().stepCount);
    std::uint32_t together = 0;
    for (std::uint32_t i = 1; i < morph.targets.size(); ++i)
    {
        if (positions[morph.firstWedge + i] != positions[morph.firstWedge + i - 1]) continue;
        EXPECT_EQ(positions[morph.targets[i].positionWedge], positions[morph.targets[i - 1].positionWedge]);
        ++together;
    }
    EXPECT_GT(together, 0u);
}

/// Mutation for the first test: targets that are off by one wedge are found.
TEST(MorphTargetsMutation, OffByOneWedgeIsSeen)
{
    const std::uint32_t finer = 10, coarser = morphed().stepCount / 2;
    const MorphTargets none{morphed().wedgesAfter(coarser), {}};
    const auto expected = facesAt(coarser, none);
    MorphTargets morph = morphTargets(morphed(), finer, coarser);
    EXPECT_EQ(facesAt(finer, morph), expected);
    std::rotate(morph.targets.begin(), morph.targets.begin() + 1, morph.targets.end());
    EXPECT_NE(facesAt(finer, morph), expected);
}

} // namespace
