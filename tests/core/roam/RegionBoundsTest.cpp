// SPDX-License-Identifier: Apache-2.0
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "SyntheticField.h"

namespace
{

using namespace osgTerrainROAM::core;

viewlod::ViewState lookingFrom(const glm::dvec3& eye, const glm::dvec3& at)
{
    return viewlod::ViewState::fromMatrices(glm::lookAt(eye, at, glm::dvec3(0, 0, 1)),
                                            glm::perspective(glm::radians(40.0), 1.5, 1.0, 1e5), 960, 640);
}

std::vector<LeafTriangle> visibleTriangles(const RoamMesh& mesh, const viewlod::ViewState& view)
{
    std::vector<TriangleRange> ranges;
    mesh.visibleRanges(view.frustum, ranges);
    return gathered(mesh.triangles(), ranges);
}

bool anyCornerSeen(const RoamMesh& mesh, const viewlod::ViewState& view, const LeafTriangle& t)
{
    for (const std::uint32_t v : t.vertices)
    {
        const auto& vertex = mesh.vertices()[v];
        const glm::dvec3 position = glm::dvec3(vertex.positionHigh) + glm::dvec3(vertex.positionLow);
        if (!view.frustum.classify(position, 0.0).outside) return true;
    }
    return false;
}

TEST(RegionBounds, NoTriangleWithACornerInThePictureIsCulled)
{
    RoamMesh mesh(testsupport::planarTile(testsupport::hills(257, 257)));
    mesh.refine(0.0);
    std::vector<TriangleRange> all;
    mesh.visibleRanges(viewlod::Frustum(glm::dmat4(0.0)), all); // no plane culls
    const auto every = gathered(mesh.triangles(), all);
    ASSERT_EQ(every.size(), mesh.tree().leaves().leafCount());
    for (int i = 0; i < 8; ++i)
    {
        const glm::dvec3 eye(3400 + 100 * i, 3800, 700);
        const auto view = lookingFrom(eye, eye + glm::dvec3(std::cos(i * 0.8), std::sin(i * 0.8), -0.2));
        const auto visible = visibleTriangles(mesh, view);
        std::size_t withCorner = 0, drawnWithCorner = 0;
        for (const auto& t : every)
            withCorner += anyCornerSeen(mesh, view, t);
        for (const auto& t : visible)
            drawnWithCorner += anyCornerSeen(mesh, view, t);
        EXPECT_EQ(drawnWithCorner, withCorner);
        EXPECT_LT(visible.size(), every.size() / 2); // and it culls at all
    }
}

TEST(RegionBounds, LookingAwayLeavesOnlyWhatIsTooCoarseToTest)
{
    RoamMesh mesh(testsupport::planarTile(testsupport::hills(129, 129)));
    mesh.refine(0.0);
    const glm::dvec3 eye(-500, -500, 600);
    EXPECT_EQ(visibleTriangles(mesh, lookingFrom(eye, eye - glm::dvec3(100, 100, 0))).size(), 0u);
}

} // namespace
