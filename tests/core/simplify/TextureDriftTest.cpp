// SPDX-License-Identifier: Apache-2.0
// Texture drift on planes of known texture coordinates.
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/Wedge.h>
#include <osgPMObjects/core/simplify/TextureDrift.h>

#include "MadeMeshes.h"

namespace
{

using namespace osgPMObjects::core;

constexpr float kTexel = 1.0f / 1024.0f;

/// A plane of 10 × 10 with one texture or a part of it.
Mesh texturedPlane(const glm::vec2& at = {0.0f, 0.0f}, float unitsPerSide = 1.0f)
{
    Mesh mesh = testsupport::grid(10, 10);
    mesh.materials[0].attributes = Material::texCoord0;
    for (const std::uint32_t p : mesh.wedgePositions)
        mesh.texCoords[0].push_back(at + glm::vec2(mesh.positions[p]) * (unitsPerSide / 10.0f));
    return mesh;
}

Mesh raised(Mesh mesh, double by)
{
    for (glm::dvec3& p : mesh.positions)
        p.z += by;
    return mesh;
}

Mesh turnedOver(Mesh mesh)
{
    for (Face& face : mesh.faces)
        std::swap(face.wedges[1], face.wedges[2]);
    return mesh;
}

/// Returns both meshes as one; faces of `b` get another material where `isOther`.
Mesh together(Mesh a, const Mesh& b, bool isOther = false)
{
    const auto positions = static_cast<std::uint32_t>(a.positions.size());
    const auto wedges = static_cast<std::uint32_t>(a.wedgeCount());
    a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
    a.texCoords[0].insert(a.texCoords[0].end(), b.texCoords[0].begin(), b.texCoords[0].end());
    for (const std::uint32_t p : b.wedgePositions)
        a.wedgePositions.push_back(positions + p);
    for (Face face : b.faces)
    {
        for (std::uint32_t& wedge : face.wedges)
            wedge += wedges;
        face.material = isOther ? 1 : 0;
        a.faces.push_back(face);
    }
    if (isOther) a.materials.push_back(a.materials[0]);
    return a;
}

std::optional<TextureDrift> driftBetween(const Mesh& original, const Mesh& level)
{
    const MeasuredSurface before(original, 5000), after(level, 5000);
    return TextureDriftMeter(before).measure(after);
}

void expectAll(const std::optional<TextureDrift>& drift, double texels, double within = 0.01)
{
    ASSERT_TRUE(drift);
    EXPECT_NEAR(drift->mean, texels, within);
    EXPECT_NEAR(drift->ofNinetyNine, texels, within);
    EXPECT_NEAR(drift->largest, texels, within);
    EXPECT_EQ(drift->samples, 5000u);
}

TEST(TextureDrift, IsNothingOnTheSameMeshAndTheShiftOnAShiftedOne)
{
    const Mesh plane = texturedPlane();
    expectAll(driftBetween(plane, plane), 0.0);
    expectAll(driftBetween(plane, texturedPlane({3.0f * kTexel, 4.0f * kTexel})), 5.0); // mutation
}

TEST(TextureDrift, DoesNotCareHowTheSurfaceIsCut)
{
    Mesh coarse = testsupport::grid(1, 1);
    coarse.materials[0].attributes = Material::texCoord0;
    for (glm::dvec3& p : coarse.positions)
    {
        coarse.texCoords[0].emplace_back(p);
        p *= 10.0;
    }
    expectAll(driftBetween(texturedPlane(), coarse), 0.0);
    expectAll(driftBetween(coarse, texturedPlane()), 0.0);
    coarse.texCoords[0][3] += glm::vec2(0.5f); // mutation: one corner is moved
    const auto drift = driftBetween(texturedPlane(), coarse);
    ASSERT_TRUE(drift);
    EXPECT_GT(drift->ofNinetyNine, 400.0);
}

TEST(TextureDrift, GrowsWithTheDistanceFromWhereAStretchBegins)
{
    const auto drift = driftBetween(texturedPlane(), texturedPlane({0.0f, 0.0f}, 1.0f + 10.0f * kTexel));
    ASSERT_TRUE(drift);
    EXPECT_NEAR(drift->largest, 10.0 * std::sqrt(2.0), 0.5);
    EXPECT_NEAR(drift->mean, 10.0 * 0.7652, 0.2); // the mean distance in a unit square from its corner
    EXPECT_LT(drift->ofNinetyNine, drift->largest);
}

TEST(TextureDrift, IsNoneWhereTheSurfaceMovesWithItsTexture)
{
    expectAll(driftBetween(texturedPlane(), raised(texturedPlane(), 0.3)), 0.0);
}

TEST(TextureDrift, TakesTheLeastOfSurfacesOnTopOfEachOther)
{
    const Mesh below = texturedPlane(), above = texturedPlane({0.5f, 0.5f});
    const Mesh both = together(below, above);
    expectAll(driftBetween(both, below), 0.0);
    expectAll(driftBetween(both, above), 0.0);
    expectAll(driftBetween(both, texturedPlane({0.5f, 0.5f + 2.0f * kTexel})), 2.0); // mutation
}

TEST(TextureDrift, LooksAtFacesOfTheSameMaterialAlone)
{
    const Mesh both = together(texturedPlane(), raised(texturedPlane({0.5f, 0.0f}), 1.0), true);
    Mesh level = together(raised(texturedPlane(), 0.9), raised(texturedPlane({0.5f, 0.0f}), 0.1), true);
    expectAll(driftBetween(both, level), 0.0);
    for (Face& face : level.faces)
        face.material = 1 - face.material; // mutation
    expectAll(driftBetween(both, level), 512.0);
}

TEST(TextureDrift, LooksAtFacesOfTheSameSideOfAThinWall)
{
    const Mesh wall = together(raised(texturedPlane(), 0.01), turnedOver(texturedPlane({0.5f, 0.0f})));
    expectAll(driftBetween(wall, raised(wall, 0.5)), 0.0);
    expectAll(driftBetween(wall, raised(turnedOver(wall), 0.5)), 512.0, 0.1); // mutation
    const Mesh front = texturedPlane();
    expectAll(driftBetween(front, turnedOver(front)), 0.0); // with one orientation only, that one counts
}

TEST(TextureDrift, OfNinetyNineOutOfAHundredLeavesOutTheRest)
{
    const Mesh plane = texturedPlane();
    const auto spoilt = [&](std::size_t faces)
    {
        Mesh level = plane;
        for (std::size_t f = 0; f < faces; ++f)
            for (std::uint32_t& wedge : level.faces[f].wedges)
            {
                Wedge other = wedgeOf(plane, wedge);
                other.texCoords[0] += glm::vec2(0.25f, 0.0f);
                wedge = appendWedge(level, other);
            }
        return driftBetween(plane, level);
    };
    const auto one = spoilt(1), four = spoilt(4); // half a per cent of the area, two per cent
    ASSERT_TRUE(one && four);
    EXPECT_NEAR(one->largest, 256.0, 0.01);
    EXPECT_NEAR(one->ofNinetyNine, 0.0, 0.01);
    EXPECT_NEAR(one->mean, 256.0 / 200.0, 0.4);
    EXPECT_NEAR(one->visibleShare, 0.005, 0.0015);
    EXPECT_NEAR(four->ofNinetyNine, 256.0, 0.01);
    EXPECT_NEAR(four->visibleShare, 0.02, 0.003);
}

TEST(TextureDrift, IsNotThereWithoutCoordinates)
{
    const Mesh textured = texturedPlane(), plain = testsupport::grid(10, 10);
    EXPECT_FALSE(driftBetween(plain, plain));
    EXPECT_FALSE(driftBetween(textured, plain));
    EXPECT_FALSE(driftBetween(plain, textured));
    Mesh unmarked = textured;
    unmarked.materials[0].attributes = 0;
    EXPECT_FALSE(driftBetween(textured, unmarked));
    Mesh empty = textured;
    empty.faces.clear();
    EXPECT_FALSE(driftBetween(textured, empty));
}

} // namespace
