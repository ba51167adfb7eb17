// SPDX-License-Identifier: Apache-2.0
#include "pmtool/polygons/WarpTexture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pmtool/polygons/CutPolygons.h"
#include "pmtool/polygons/ReadPolygons.h"

namespace
{

using osgPMObjects::core::TexturedQuad;
using testing::HasSubstr;

/// A texture whose colour is its own place: red is u, green is v, but where it begins anew.
pmtool::Texels placeTexture(std::uint32_t size)
{
    pmtool::Texels texels{size, size, {}};
    for (std::uint32_t t = 0; t < size; ++t)
        for (std::uint32_t s = 0; s < size; ++s)
            texels.colours.emplace_back((s + 0.5f) / float(size), (t + 0.5f) / float(size), 0.0f, 1.0f);
    return texels;
}

/// A trapezoid that shows the texture from 0.1 to 0.9.
pmtool::TexturedFace warpedFace(double top)
{
    return {{{{{-1, 0, 0}, {1, 0, 0}, {top, 1, 0}, {-top, 1, 0}}},
             {{{0.1, 0.1}, {0.9, 0.1}, {0.9, 0.9}, {0.1, 0.9}}}},
            true,
            "line 1"};
}

glm::dvec2 texelShownAt(const pmtool::Texels& texels, const glm::dvec2& place)
{
    const auto s = static_cast<std::size_t>(place.x * texels.width),
               t = static_cast<std::size_t>(place.y * texels.height);
    const glm::vec4& c = texels.colours[t * texels.width + s];
    return {c.r, c.g};
}

/// Returns how far two triangles along corners 0 and 2 show the texture from where the bilinear patch has it.
double driftOfTriangles(const TexturedQuad& quad, const pmtool::Texels& texels)
{
    double most = 0.0;
    for (int i = 1; i < 20; ++i)
        for (int j = 1; i + j < 20; ++j)
            for (const std::size_t side : {std::size_t(1), std::size_t(3)})
            {
                std::array<double, 4> weights{};
                weights[0] = (20 - i - j) / 20.0;
                weights[side] = i / 20.0;
                weights[2] = j / 20.0;
                glm::dvec2 place(0.0);
                for (std::size_t k = 0; k < 4; ++k)
                    place += weights[k] * quad.texCoords[k];
                const auto wanted = preWarpedTexCoord(quad, weights);
                EXPECT_TRUE(wanted);
                most = std::max(most, glm::distance(texelShownAt(texels, place), *wanted));
            }
    return most;
}

TEST(WarpTexture, TwoTrianglesShowTheBilinearPatch)
{
    const std::array faces{warpedFace(0.3)};
    const pmtool::Texels texture = placeTexture(256);
    const auto warped = pmtool::warpTexture(texture, faces);
    ASSERT_TRUE(warped) << warped.error().message();
    EXPECT_LT(driftOfTriangles(faces[0].quad, *warped),
              3.0 / 256.0);                                   // the nearest texel, where it is stretched
    EXPECT_GT(driftOfTriangles(faces[0].quad, texture), 0.1); // the mutation: without warping
}

TEST(WarpTexture, StaysAlongBordersAndBesideTheQuad)
{
    const std::array faces{warpedFace(0.3)};
    const pmtool::Texels texture = placeTexture(64);
    const auto warped = pmtool::warpTexture(texture, faces);
    ASSERT_TRUE(warped);
    std::size_t changed = 0;
    for (std::uint32_t t = 0; t < 64; ++t)
        for (std::uint32_t s = 0; s < 64; ++s)
        {
            const std::size_t i = t * 64 + s;
            const float apart = glm::distance(warped->colours[i], texture.colours[i]);
            const bool isInside = std::min({s, t, 63 - s, 63 - t}) >= 7;
            if (!isInside)
            {
                EXPECT_LT(apart, 1.5f / 64.0f) << s << ' ' << t;
            }
            if (std::min({s, t, 63 - s, 63 - t}) < 6)
            {
                EXPECT_EQ(apart, 0.0f);
            }
            changed += apart > 0.05f;
        }
    EXPECT_GT(changed, 300u);
}

TEST(WarpTexture, OfAParallelogramIsTheTexture)
{
    const std::array faces{warpedFace(1.0)};
    const pmtool::Texels texture = placeTexture(64);
    const auto warped = pmtool::warpTexture(texture, faces);
    ASSERT_TRUE(warped);
    for (std::size_t i = 0; i < texture.colours.size(); ++i)
        EXPECT_LT(glm::distance(warped->colours[i], texture.colours[i]), 1e-5f) << i;
}

TEST(WarpTexture, RepeatsBeyondItsBorders)
{
    pmtool::TexturedFace moved = warpedFace(0.3);
    for (glm::dvec2& t : moved.quad.texCoords)
        t += glm::dvec2(-3.0, 2.0);
    const pmtool::Texels texture = placeTexture(64);
    const auto a = pmtool::warpTexture(texture, std::array{warpedFace(0.3)}),
               b = pmtool::warpTexture(texture, std::array{moved, warpedFace(0.3)}); // they want the same
    ASSERT_TRUE(a && b);
    for (std::size_t i = 0; i < a->colours.size(); ++i)
        EXPECT_LT(glm::distance(a->colours[i], b->colours[i]), 1e-4f) << i;
}

TEST(WarpTexture, RefusesTexelsThatTwoFacesShowOtherwise)
{
    pmtool::TexturedFace other = warpedFace(0.5), triangle = warpedFace(0.3), far = warpedFace(0.3);
    other.location = "line 7";
    triangle.isQuad = false;
    for (const auto& second : {other, triangle})
    {
        const auto warped = pmtool::warpTexture(placeTexture(64), std::array{warpedFace(0.3), second});
        ASSERT_FALSE(warped);
        EXPECT_EQ(warped.error().place, second.location);
        EXPECT_THAT(warped.error().what, HasSubstr("line 1"));
    }
    far.quad.texCoords[1].x = 1e9;
    EXPECT_FALSE(pmtool::warpTexture(placeTexture(64), std::array{far}));
    far.quad.texCoords[1].x = std::nan("");
    EXPECT_FALSE(pmtool::warpTexture(placeTexture(64), std::array{far}));
}

/// A trapezoid beside a square, and a triangle, with texture coordinates.
constexpr const char* kTrapezoidObj =
    "v -1 0 0\nv 1 0 0\nv .5 1 0\nv -.5 1 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 0 2 0\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\nf 2/1 5/2 6/3 7/4\n"
    "f 4/1 3/2 8/3\n";

TEST(CutPolygons, ProjectiveCoordinatesAreOfQuadsThatNeedThem)
{
    const auto set = pmtool::parseObj(kTrapezoidObj, "a.obj");
    ASSERT_TRUE(set);
    const auto cut = pmtool::cutPolygons(*set, {.quadTexture = pmtool::QuadTexture::projective}, "a.obj");
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut->counts.warpedQuads, 2u);
    EXPECT_EQ(cut->faces.size(), 5u);
    ASSERT_EQ(cut->texDivisors.size(), cut->positions.size());
    EXPECT_EQ(cut->positions.size(), set->positions.size() + 4); // the trapezoid's own corners
    const auto divisor = [&](std::size_t face, std::size_t corner)
    { return cut->texDivisors[cut->faces[face][corner]]; };
    EXPECT_NEAR(divisor(0, 0) / divisor(0, 2), 2.0, 1e-12); // the long side to the short one
    EXPECT_EQ(divisor(2, 0), 1.0);
    EXPECT_EQ(divisor(4, 0), 1.0);
    EXPECT_THAT(pmtool::objTextOf(*cut), HasSubstr("vt 1 1 1\n"));
}

TEST(CutPolygons, PreWarpedQuadsAreCutAlongTheirFirstCorner)
{
    const auto set =
        pmtool::parseObj(std::string(kTrapezoidObj) + "v -.4 .6 0\nf 1/1 9/2 3/3 4/4\n", "a.obj");
    ASSERT_TRUE(set);
    const auto cut = pmtool::cutPolygons(*set, {.quadTexture = pmtool::QuadTexture::preWarped}, "a.obj");
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut->counts.warpedQuads, 2u);
    EXPECT_EQ(cut->counts.refusedQuads, 1u); // the last, which is not convex
    ASSERT_EQ(cut->texturedFaces.size(), 5u);
    EXPECT_TRUE(cut->texturedFaces[0].isQuad);
    EXPECT_FALSE(cut->texturedFaces[2].isQuad);
    EXPECT_EQ(cut->faces[0][0], cut->faces[1][0]);
    EXPECT_TRUE(cut->texDivisors.empty());
    const auto refused = pmtool::warpTexture(placeTexture(64), cut->texturedFaces);
    ASSERT_FALSE(refused); // all show the same texels
    EXPECT_EQ(refused.error().place, "line 14");
}

} // namespace
