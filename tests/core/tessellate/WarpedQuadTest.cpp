// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <osgPMObjects/core/tessellate/WarpedQuad.h>

#include "Random.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::Random;

TexturedQuad trapezoid(double top)
{
    return {{{{-1, 0, 0}, {1, 0, 0}, {top, 1, 0}, {-top, 1, 0}}}, {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}};
}

/// Returns a flat convex quad: corners on a circle.
TexturedQuad randomQuad(Random& random)
{
    TexturedQuad quad = trapezoid(1.0);
    for (int i = 0; i < 4; ++i)
    {
        const double angle = std::numbers::pi / 2.0 * (i + 0.7 * random.unit());
        quad.positions[i] = {std::cos(angle), std::sin(angle), 0.0};
    }
    return quad;
}

/// Returns the (s, t) of a position on the patch, by Newton's method.
glm::dvec2 sharesOf(const TexturedQuad& quad, const glm::dvec3& position)
{
    glm::dvec2 shares(0.5);
    for (int i = 0; i < 50; ++i)
    {
        const double h = 1e-6;
        const glm::dvec3 off = position - positionAt(quad, shares);
        const glm::dvec3 ds = (positionAt(quad, shares + glm::dvec2(h, 0)) - positionAt(quad, shares)) / h;
        const glm::dvec3 dt = (positionAt(quad, shares + glm::dvec2(0, h)) - positionAt(quad, shares)) / h;
        const double determinant = ds.x * dt.y - ds.y * dt.x;
        shares += glm::dvec2(off.x * dt.y - off.y * dt.x, ds.x * off.y - ds.y * off.x) / determinant;
    }
    return shares;
}

/// Returns the largest distance of the texture from its intended position.
double drift(const TexturedQuad& quad, const QuadGrid& grid)
{
    double most = 0.0;
    for (const Triangle& t : grid.triangles)
        for (int i = 0; i <= 6; ++i)
            for (int j = 0; i + j <= 6; ++j)
            {
                const glm::dvec3 w(i / 6.0, j / 6.0, (6 - i - j) / 6.0);
                glm::dvec3 position(0.0);
                glm::dvec2 shown(0.0);
                for (int k = 0; k < 3; ++k)
                {
                    position += w[k] * grid.positions[t[k]];
                    shown += w[k] * grid.texCoords[t[k]];
                }
                most = std::max(most, glm::distance(shown, texCoordAt(quad, sharesOf(quad, position))));
            }
    return most;
}

TEST(WarpedQuad, OfAParallelogramIsOneCell)
{
    const auto grid = meshQuad(trapezoid(1.0), 1e-6);
    ASSERT_TRUE(grid);
    EXPECT_EQ(grid->cells, 1u);
    EXPECT_EQ(grid->triangles.size(), 2u);
}

TEST(WarpedQuad, FinerMeshingHoldsTheTexture)
{
    Random random(41);
    int improved = 0;
    for (int i = 0; i < 100; ++i)
    {
        const TexturedQuad quad = randomQuad(random);
        const auto coarse = meshQuad(quad, 1e6);
        const auto grid = meshQuad(quad, 0.02);
        ASSERT_TRUE(coarse);
        ASSERT_TRUE(grid) << grid.error().message();
        EXPECT_EQ(coarse->cells, 1u);
        EXPECT_LE(drift(quad, *grid), 0.02);
        improved += drift(quad, *coarse) > 0.02; // the mutation: two triangles do not hold it
    }
    EXPECT_GT(improved, 80);
}

TEST(WarpedQuad, RefusesWhatNoMeshHolds)
{
    EXPECT_FALSE(meshQuad(trapezoid(0.5), 0.0));
    EXPECT_FALSE(meshQuad(trapezoid(0.5), std::nan("")));
    EXPECT_FALSE(meshQuad(trapezoid(0.5), 1e-9));
    EXPECT_FALSE(meshQuad(trapezoid(-0.5), 0.1)); // a bow-tie
}

TEST(WarpedQuad, WarpedTextureIsThePatchs)
{
    Random random(42);
    double affineDrift = 0.0;
    for (int i = 0; i < 1000; ++i)
    {
        const TexturedQuad quad = randomQuad(random);
        double a = random.unit(), b = random.unit();
        if (a + b > 1.0) a = 1.0 - a, b = 1.0 - b;
        std::array<double, 4> weights = {1.0 - a - b, 0.0, b, 0.0};
        weights[random.below(2) == 0 ? 1 : 3] = a;
        glm::dvec3 position(0.0);
        glm::dvec2 affine(0.0);
        for (int k = 0; k < 4; ++k)
        {
            position += weights[k] * quad.positions[k];
            affine += weights[k] * quad.texCoords[k];
        }
        const auto warped = preWarpedTexCoord(quad, weights);
        ASSERT_TRUE(warped);
        const glm::dvec2 expected = texCoordAt(quad, sharesOf(quad, position));
        EXPECT_LT(glm::distance(*warped, expected), 1e-6);
        affineDrift = std::max(affineDrift, glm::distance(affine, expected));
    }
    EXPECT_GT(affineDrift, 0.1); // the mutation: without warping
}

TEST(WarpedQuad, WarpedTextureOfAParallelogramIsTheTexture)
{
    const TexturedQuad quad = trapezoid(1.0);
    const auto warped = preWarpedTexCoord(quad, {0.2, 0.3, 0.5, 0.0});
    ASSERT_TRUE(warped);
    EXPECT_LT(glm::distance(*warped, glm::dvec2(0.8, 0.5)), 1e-12);
    for (int corner = 0; corner < 4; ++corner)
    {
        std::array<double, 4> weights{};
        weights[corner] = 1.0;
        const auto atCorner = preWarpedTexCoord(trapezoid(0.3), weights);
        ASSERT_TRUE(atCorner) << corner;
        EXPECT_LT(glm::distance(*atCorner, quad.texCoords[corner]), 1e-9);
    }
}

TEST(WarpedQuad, ProjectiveTextureGoesOnStraightAcrossTheDiagonal)
{
    Random random(43);
    for (int i = 0; i < 1000; ++i)
    {
        TexturedQuad quad = randomQuad(random);
        if (i % 2) // any convex part of the texture
            for (int k = 0; const glm::dvec3& p : randomQuad(random).positions)
                quad.texCoords[k++] = glm::dvec2(p);
        const auto coords = projectiveTexCoords(quad);
        ASSERT_TRUE(coords);
        // One projective map for both triangles: the fourth corner follows from the other three by the same
        // weights.
        const glm::dvec3 &p0 = quad.positions[0], &p1 = quad.positions[1], &p2 = quad.positions[2],
                         &p3 = quad.positions[3];
        const auto area = [](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
        { return glm::cross(b - a, c - a).z; };
        const double whole = area(p0, p1, p2);
        const glm::dvec3 fourth = (area(p3, p1, p2) * (*coords)[0] + area(p0, p3, p2) * (*coords)[1] +
                                   area(p0, p1, p3) * (*coords)[2]) /
                                  whole;
        EXPECT_LT(glm::distance(glm::dvec2(fourth) / fourth.z, quad.texCoords[3]), 1e-9);
        EXPECT_LT(std::abs(fourth.z / (*coords)[3].z - 1.0), 1e-9);
    }
    EXPECT_FALSE(projectiveTexCoords(trapezoid(-0.5)));
    TexturedQuad flat = trapezoid(0.5);
    flat.texCoords[2] = flat.texCoords[1]; // a part of the texture without area
    flat.texCoords[3] = flat.texCoords[0];
    EXPECT_FALSE(projectiveTexCoords(flat));
}

TEST(WarpedQuad, ProjectiveTextureOfAnAffineMapNeedsNoDivision)
{
    Random random(44);
    TexturedQuad quad = randomQuad(random);
    for (std::size_t k = 0; k < 4; ++k)
        quad.texCoords[k] = glm::dvec2(0.3 * quad.positions[k].x - quad.positions[k].y, quad.positions[k].x);
    const auto coords = projectiveTexCoords(quad);
    ASSERT_TRUE(coords);
    for (const glm::dvec3& c : *coords)
        EXPECT_NEAR(c.z / (*coords)[0].z, 1.0, 1e-12);
}

} // namespace
