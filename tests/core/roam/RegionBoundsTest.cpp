// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

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

std::vector<LeafTriangle> visibleTriangles(const RoamMesh& mesh, const viewlod::Frustum& frustum)
{
    std::vector<TriangleRange> ranges;
    mesh.visibleRanges(frustum, ranges);
    std::vector<LeafTriangle> triangles;
    for (const TriangleRange& range : ranges)
        for (std::uint32_t slot = range.first; slot < range.first + range.count; ++slot)
            if (mesh.tree().leaves().leaf(slot).exists()) triangles.push_back(mesh.triangle(slot));
    return triangles;
}

bool anyCornerSeen(const RoamMesh& mesh, const viewlod::ViewState& view, const LeafTriangle& t)
{
    return std::any_of(
        std::begin(t.vertices), std::end(t.vertices),
        [&](VertexSlot v)
        {
            const GridPoint p = mesh.tree().place(v).point();
            return !view.frustum.classify(mesh.tile().tile.position(p.column, p.row), 0.0).outside;
        });
}

TEST(RegionBounds, NoTriangleWithACornerInThePictureIsCulled)
{
    RoamMesh mesh(testsupport::planarTile(testsupport::hills(257, 257)));
    mesh.refine(0.0);
    const auto every = visibleTriangles(mesh, viewlod::Frustum(glm::dmat4(0.0))); // no plane culls
    ASSERT_EQ(every.size(), mesh.tree().leaves().leafCount());
    for (int i = 0; i < 8; ++i)
    {
        const glm::dvec3 eye(3400 + 100 * i, 3800, 700);
        const auto view = lookingFrom(eye, eye + glm::dvec3(std::cos(i * 0.8), std::sin(i * 0.8), -0.2));
        const auto visible = visibleTriangles(mesh, view.frustum);
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
    EXPECT_EQ(visibleTriangles(mesh, lookingFrom(eye, eye - glm::dvec3(100, 100, 0)).frustum).size(), 0u);
}

} // namespace
