// SPDX-License-Identifier: Apache-2.0
#include "PictureRing.h"

#include <gtest/gtest.h>

#include "Random.h"
#include "TriangleRaster.h"

namespace
{

using namespace osgPMObjects::core;

const MaterialLook kWhite;

SeenFace faceOf(std::uint32_t number, const std::array<glm::dvec3, 3>& corners)
{
    SeenFace face;
    face.number = number;
    face.corners = corners;
    face.luminances = {1.0f, 1.0f, 1.0f};
    face.material.look = &kWhite;
    face.material.isTwoSided = true;
    return face;
}

SeenFace randomFace(testsupport::Random& random, std::uint32_t number)
{
    const auto place = [&]
    { return glm::dvec3(random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5); };
    SeenFace face = faceOf(number, {place(), place(), place()});
    for (float& luminance : face.luminances)
        luminance = static_cast<float>(random.unit());
    face.material.isTransparent = random.below(4) == 0;
    return face;
}

TEST(TriangleRaster, CoversPixelsWhoseCentresAreInside)
{
    std::vector<std::uint32_t> pixels;
    rasterise({{{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0}}}, 4,
              [&](std::uint32_t pixel, const glm::dvec3& shares)
              {
                  pixels.push_back(pixel);
                  EXPECT_NEAR(shares.x + shares.y + shares.z, 1.0, 1e-12);
              });
    EXPECT_EQ(pixels, (std::vector<std::uint32_t>{0, 1, 4}));
}

TEST(TriangleRaster, CutsAtThePictureAndLeavesOutWhatHasNoArea)
{
    std::size_t pixels = 0;
    const auto count = [&](std::uint32_t pixel, const glm::dvec3&)
    {
        EXPECT_LT(pixel, 16u);
        ++pixels;
    };
    rasterise({{{-50.0, -50.0, 0.0}, {100.0, -50.0, 0.0}, {-50.0, 100.0, 0.0}}}, 4, count);
    EXPECT_EQ(pixels, 16u);
    rasterise({{{0.0, 0.0, 0.0}, {2.0, 2.0, 0.0}, {4.0, 4.0, 0.0}}}, 4, count);
    EXPECT_EQ(pixels, 16u);
}

/// The nearer of two faces is visible from either side; when it is removed, the other appears.
TEST(PictureRing, ShowsWhatWasHidden)
{
    const PolishSettings settings{.views = 2, .sizePx = 16, .background = 0.0f}; // about from above and below
    const std::array<glm::dvec3, 3> flat{{{-0.4, -0.4, 0.1}, {0.4, -0.4, 0.1}, {0.0, 0.4, 0.1}}};
    const SeenFace above = faceOf(0, flat);
    SeenFace below = above;
    below.number = 1;
    for (glm::dvec3& corner : below.corners)
        corner.z = -0.1;
    PictureRing both(settings, 2), one(settings, 2);
    both.addAll(std::vector{above, below});
    one.addAll(std::vector{below});
    both.setReference(one);
    EXPECT_GT(both.squaredError(), 0.0); // white on black where the two do not overlap
    EXPECT_DOUBLE_EQ(both.change(std::vector{above}, {}), -both.squaredError());
    both.replace(std::vector{above}, {});
    EXPECT_EQ(both.squaredError(), 0.0);
}

/// A predicted change is the actual one, and images after additions and removals equal those of the remaining
/// faces.
TEST(PictureRing, StaysThePictureOfItsFaces)
{
    constexpr std::uint32_t kFaces = 40;
    testsupport::Random random(3);
    const PolishSettings settings{.views = 5, .sizePx = 32};
    std::vector<SeenFace> original, faces;
    for (std::uint32_t i = 0; i < kFaces; ++i)
        original.push_back(randomFace(random, i));
    faces = original;
    PictureRing reference(settings, kFaces), ring(settings, kFaces);
    reference.addAll(original);
    ring.setReference(reference);
    ring.addAll(faces);
    EXPECT_EQ(ring.squaredError(), 0.0);
    for (int step = 0; step < 300; ++step)
    {
        const std::uint32_t first = random.below(kFaces - 3);
        const std::vector<SeenFace> removed(faces.begin() + first, faces.begin() + first + 3);
        for (std::uint32_t i = first; i < first + 3; ++i)
            faces[i] = randomFace(random, i);
        const std::vector<SeenFace> added(faces.begin() + first, faces.begin() + first + 3);
        const double told = ring.squaredError() + ring.change(removed, added);
        ring.replace(removed, added);
        ASSERT_NEAR(ring.squaredError(), told, 1e-6);
    }
    PictureRing fresh(settings, kFaces);
    fresh.setReference(reference);
    fresh.addAll(faces);
    EXPECT_NEAR(ring.squaredError(), fresh.squaredError(), 1e-9);
    fresh.replace(std::vector{faces[0]}, {}); // mutation: the comparison can fail
    EXPECT_NE(ring.squaredError(), fresh.squaredError());
}

} // namespace
