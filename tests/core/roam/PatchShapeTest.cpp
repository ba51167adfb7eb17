// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/PatchShape.h>
#include <osgTerrainROAM/core/roam/SplitBounds.h>

namespace
{

using namespace osgTerrainROAM::core;

using Corners = std::array<std::pair<int, int>, 3>;

Corners cornersOf(const GridTriangle& t)
{
    return {{{t.apex.column, t.apex.row}, {t.left.column, t.left.row}, {t.right.column, t.right.row}}};
}

/// The bintree's own descendants.
void addDescendants(const GridTriangle& t, int levels, std::set<Corners>& out)
{
    if (levels == 0)
        out.insert(cornersOf(t));
    else
        for (const GridTriangle& half : t.children())
            addDescendants(half, levels - 1, out);
}

class PatchShapes : public testing::TestWithParam<int>
{
};

TEST_P(PatchShapes, AreTheLeafsDescendants)
{
    const int exponent = GetParam();
    const PatchShape& shape = PatchShape::of(exponent);
    // Triangles of both kinds, legs along axes and diagonals, as large as the tile and as small as a patch
    // can be.
    const int side = (1 << (SplitBounds::kMostExponent / 2 + 1)) + 1;
    GridTriangle leaf = rootTriangles(side)[0];
    const int levels = SplitBounds::kMostExponent + 2;
    for (int level = 0; level + exponent <= levels; ++level, leaf = leaf.children()[level % 2])
    {
        std::set<Corners> wanted, found;
        addDescendants(leaf, exponent, wanted);
        for (const PatchShape::Triangle& t : shape.triangles)
        {
            const auto at = [&](std::size_t i) { return shape.gridPoint(leaf, shape.vertices[t[i]]); };
            found.insert(cornersOf({at(0), at(1), at(2)}));
        }
        EXPECT_EQ(found, wanted) << "level " << level;
    }
    const std::size_t segments = static_cast<std::size_t>(shape.segments);
    EXPECT_EQ(shape.triangles.size(), 1u << exponent);
    EXPECT_EQ(shape.vertices.size(), (segments + 1) * (segments + 2) / 2) << "each vertex once";
}

TEST_P(PatchShapes, GoFromTriangleToTriangleOverAnEdge)
{
    const auto& triangles = PatchShape::of(GetParam()).triangles;
    for (std::size_t i = 1; i < triangles.size(); ++i)
    {
        int shared = 0;
        for (const std::uint16_t v : triangles[i])
            shared += static_cast<int>(std::count(triangles[i - 1].begin(), triangles[i - 1].end(), v));
        EXPECT_EQ(shared, 2) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Exponents, PatchShapes, testing::Values(0, 2, 4, 6, 8, 10));

} // namespace
