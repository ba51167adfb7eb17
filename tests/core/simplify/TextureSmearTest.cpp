// SPDX-License-Identifier: Apache-2.0
// How far away from its place a level shows its texture, on planes of known texture coordinates.
#include <algorithm>
#include <cstddef>

#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/Wedge.h>
#include <osgPMObjects/core/simplify/TextureSmear.h>

#include "MadeMeshes.h"

namespace
{

using namespace osgPMObjects::core;

/// A plane of 10 × 10 units; its left half shows one chart of the image, its right half another one.
Mesh planeOfTwoCharts(const glm::vec2& shift = {0.0f, 0.0f})
{
    Mesh mesh = testsupport::grid(10, 10);
    mesh.materials[0].attributes = Material::texCoord0;
    mesh.texCoords[0].resize(mesh.wedgeCount());
    Mesh charted = mesh;
    charted.wedgePositions.clear(), charted.texCoords[0].clear();
    for (Face& face : charted.faces)
    {
        double left = 10.0;
        for (const std::uint32_t wedge : face.wedges)
            left = std::min(left, mesh.positions[mesh.wedgePositions[wedge]].x);
        const glm::vec2 chart(left < 5.0 ? 0.0f : 3.0f, 0.0f);
        for (std::uint32_t& number : face.wedges)
        {
            Wedge wedge = wedgeOf(mesh, number);
            wedge.texCoords[0] = chart + shift + glm::vec2(mesh.positions[wedge.position]) / 10.0f;
            number = appendWedge(charted, wedge);
        }
    }
    return charted;
}

std::optional<TextureSmear> smearBetween(const Mesh& original, const Mesh& level, double allowed = 0.5)
{
    const MeasuredSurface before(original, 5000), after(level, 5000);
    return TextureSmearMeter(before).measure(after, allowed);
}

TEST(TextureSmear, IsTheWayThatTheTextureHasGone)
{
    const Mesh plane = planeOfTwoCharts();
    const auto none = smearBetween(plane, plane);
    ASSERT_TRUE(none);
    EXPECT_NEAR(none->ofNinetyNine, 0.0, 1e-5);
    EXPECT_EQ(none->farShare, 0.0);
    const auto moved = smearBetween(plane, planeOfTwoCharts({0.03f, 0.04f})); // mutation: half a unit away
    ASSERT_TRUE(moved);
    EXPECT_NEAR(moved->ofNinetyNine, 0.5, 0.02);
    EXPECT_NEAR(smearBetween(plane, planeOfTwoCharts({0.03f, 0.04f}), 0.6)->farShare, 0.08,
                0.03); // out of the charts
    EXPECT_GT(smearBetween(plane, planeOfTwoCharts({0.03f, 0.04f}), 0.4)->farShare, 0.95);
}

TEST(TextureSmear, IsSmallWhereTheBorderOfTwoChartsHasMoved)
{
    Mesh plane = planeOfTwoCharts(), level = plane;
    for (glm::dvec3& p : level.positions)
        if (p.x == 5.0) p.x += 0.1;
    const auto smear = smearBetween(plane, level, 0.2);
    ASSERT_TRUE(smear);
    EXPECT_LE(smear->ofNinetyNine, 0.1 + 1e-6);
    EXPECT_EQ(smear->farShare, 0.0);
}

TEST(TextureSmear, IsEverywhereBetweenTwoCharts)
{
    const Mesh plane = planeOfTwoCharts();
    Mesh level = plane;
    std::size_t spoilt = 0;
    for (std::size_t f = 0; f < level.faces.size() && spoilt < 20; ++f, ++spoilt) // a tenth of the area
        level.texCoords[0][level.faces[f].wedges[0]].x += 3.0f;                   // mutation
    const auto smear = smearBetween(plane, level);
    ASSERT_TRUE(smear);
    EXPECT_NEAR(smear->farShare, 0.1, 0.03);
}

TEST(TextureSmear, IsNotThereWithoutCoordinates)
{
    const Mesh textured = planeOfTwoCharts(), plain = testsupport::grid(10, 10);
    EXPECT_FALSE(smearBetween(plain, textured));
    EXPECT_FALSE(smearBetween(textured, plain));
}

} // namespace
