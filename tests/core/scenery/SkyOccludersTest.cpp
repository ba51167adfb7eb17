// SPDX-License-Identifier: Apache-2.0
// What walls and discs hide of the sky is what a sum over all its directions says.
#include "scenery/placement/SkyOccluders.h"

#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

namespace
{

using namespace scenery;

/// The share of an even sky's light on level ground that comes from where `isHidden` says so.
double hiddenBySum(const std::function<bool(const glm::dvec3&)>& isHidden)
{
    constexpr int kRings = 400, kTurns = 800;
    double hidden = 0.0;
    for (int i = 0; i < kRings; ++i)
        for (int j = 0; j < kTurns; ++j)
        {
            // Rings of one share of the light each: the square of the sine is even.
            const double sine2 = (i + 0.5) / kRings, turn = 2.0 * std::numbers::pi * (j + 0.5) / kTurns;
            const double sine = std::sqrt(sine2);
            hidden += isHidden({sine * std::cos(turn), sine * std::sin(turn), std::sqrt(1.0 - sine2)});
        }
    return hidden / (kRings * kTurns);
}

bool meetsDisc(const glm::dvec3& way, double awayM, double radiusM, double heightM)
{
    const glm::dvec2 at = glm::dvec2(way) * (heightM / way.z);
    return glm::length(at - glm::dvec2(awayM, 0.0)) < radiusM;
}

TEST(SkyOccluders, AWallHidesWhatASumOverTheSkySays)
{
    for (const double awayM : {0.0, 0.5, 2.0, 6.0})
    {
        const double sum =
            hiddenBySum([&](const glm::dvec3& way) { return way.x > 0.0 && way.z * awayM < 6.0 * way.x; });
        EXPECT_NEAR(hiddenByWall(awayM, 6.0), 0.75 * sum, 2e-3) << awayM;
        if (awayM == 0.0) continue; // there the height does not count
        EXPECT_GT(std::abs(hiddenByWall(awayM, 4.0) - 0.75 * sum), 4e-3) << "the mutation";
    }
}

TEST(SkyOccluders, ADiscHidesWhatASumOverTheSkySays)
{
    for (const double awayM : {0.0, 2.0, 4.0, 7.0})
    {
        const double sum =
            hiddenBySum([&](const glm::dvec3& way) { return meetsDisc(way, awayM, 4.0, 2.2); });
        EXPECT_NEAR(hiddenByDisc(awayM, 4.0, 2.2), sum, 2e-3) << awayM;
        EXPECT_GT(std::abs(hiddenByDisc(awayM, 4.0, 2.6) - sum), 4e-3) << "the mutation";
    }
}

TEST(SkyOccluders, ModelsHideByTheirKind)
{
    SceneryDescription description;
    for (const models::Kind kind : {models::Kind::oak, models::Kind::van, models::Kind::barn})
    {
        description.fields.emplace_back();
        description.fields.back().objects = {{kind, 1, {}}};
    }
    PlacedScenery placed;
    for (std::uint32_t i = 0; i < 3; ++i)
        placed.placements.push_back({{10.0 * i, 5.0, 2.0}, uprightAxes(0.5), 1.5, i, i});
    std::vector<Measures> measures(3);
    measures[0].radiusM = 4.0;
    for (std::size_t i : {1, 2})
    {
        measures[i].baseLow = {-2.0, -1.0};
        measures[i].baseHigh = {3.0, 1.0};
    }
    const SkyOccluders occluders = occludersOf(description, placed, measures);
    ASSERT_EQ(occluders.bodies.size(), 2U);
    EXPECT_EQ(occluders.walls.size(), 4U) << "of the barn";
    EXPECT_NEAR(occluders.bodies[0].halfM.x, 1.5 * 0.8 * 4.0, 1e-12);
    EXPECT_NEAR(occluders.bodies[1].halfM.x, 1.5 * 2.5, 1e-12);
    EXPECT_NEAR(occluders.bodies[1].place.x, 10.0 + 1.5 * 0.5 * std::cos(0.5), 1e-12);
    for (const SkyWall& wall : occluders.walls)
    {
        const glm::dvec2 along = wall.to - wall.from, out(along.y, -along.x);
        const glm::dvec2 middle = glm::dvec2(placed.placements[2].position) +
                                  glm::dvec2(uprightAxes(0.5) * glm::dvec3(0.75, 0.0, 0.0));
        EXPECT_GT(glm::dot(out, 0.5 * (wall.from + wall.to) - middle), 0.0) << "it looks outwards";
    }
}

} // namespace
