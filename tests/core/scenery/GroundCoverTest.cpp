// SPDX-License-Identifier: Apache-2.0
// What grows near the eye: where it may, on the ground, the same whenever one comes.
#include "scenery/placement/GroundCover.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace
{

using namespace scenery;

/// A slope with a road along x = 3, 1 m to either side, bare from y = 6 on.
std::optional<CoverGround> ground(glm::dvec2 place)
{
    if (std::abs(place.x - 3.0) < 1.0) return std::nullopt;
    return CoverGround{0.25 * place.x, place.y < 6.0 ? 1.0F : 0.0F, 0.0F, 0.0F};
}

bool areOnGround(const std::vector<CoverThing>& things)
{
    return std::all_of(things.begin(), things.end(),
                       [](const CoverThing& thing)
                       {
                           const auto below = ground(glm::dvec2(thing.position));
                           return below && std::abs(below->heightM - thing.position.z) < 1e-9;
                       });
}

} // namespace

TEST(GroundCover, StandsOnTheGroundAndNotOnRoads)
{
    std::vector<CoverThing> things = coverOf({0, 0}, 0, ground);
    ASSERT_GT(things.size(), 60U);
    EXPECT_TRUE(areOnGround(things));
    for (const CoverThing& thing : things)
    {
        EXPECT_LT(thing.position.y, 6.0);
        EXPECT_TRUE(thing.position.x >= 0.0 && thing.position.x < kCoverCellM);
    }
    things[5].position.z += 0.1;
    EXPECT_FALSE(areOnGround(things)) << "the mutation: grass floating by 10 cm";
}

TEST(GroundCover, FartherCellsHaveSomeOfTheSameThings)
{
    const auto all = coverOf({-7, 12}, 0, [](glm::dvec2) { return CoverGround{1.0, 0.7F, 0.2F, 0.1F}; });
    const auto far = coverOf({-7, 12}, 2, [](glm::dvec2) { return CoverGround{1.0, 0.7F, 0.2F, 0.1F}; });
    EXPECT_LT(far.size(), all.size() / 2);
    for (const CoverThing& thing : far)
        EXPECT_TRUE(std::any_of(all.begin(), all.end(),
                                [&](const CoverThing& other) {
                                    return other.position == thing.position && other.shape == thing.shape &&
                                           other.scale == thing.scale;
                                }));
}
