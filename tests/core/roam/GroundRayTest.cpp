// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgTerrainROAM/core/heightfield/GroundQuery.h>
#include <osgTerrainROAM/core/roam/DiamondTree.h>
#include <osgTerrainROAM/core/roam/GroundRay.h>

#include "SyntheticField.h"
#include "TreeWalks.h"
#include "measurement/SplitFully.h"

namespace
{

using namespace osgTerrainROAM::core;
using testsupport::Random;

class GroundRay : public testing::TestWithParam<bool>
{
protected:
    GroundRay() : _tile(tileOf(GetParam())), _tree(_tile) { measurement::splitFully(_tree); }

    static std::shared_ptr<const RoamTile> tileOf(bool curved)
    {
        HeightField field = testsupport::hills(30, 33);
        return std::make_shared<const RoamTile>(curved ? PlacedTile(testsupport::onTheEarth(std::move(field)))
                                                       : PlacedTile(std::move(field), Placement::planar));
    }

    glm::dvec3 placeAt(Random& random, double aboveM) const
    {
        const PlacedTile& tile = _tile->tile;
        return tile.frame().positionAt(random.unit() * (tile.grid().dataColumns() - 1),
                                       random.unit() * (tile.grid().dataRows() - 1), 400.0 + aboveM);
    }

    /// The nearest of all full-resolution triangles, each solved as a system of three equations.
    double bruteForce(const glm::dvec3& origin, const glm::dvec3& direction) const
    {
        double nearest = 1e300;
        for (const testsupport::CornerIndices& t : testsupport::leafSet(_tree))
        {
            const auto at = [&](std::size_t i) { return _tile->tile.position(t[2 * i], t[2 * i + 1]); };
            const auto beyond = [&](std::size_t axis, int limit) {
                return std::min({t[axis], t[2 + axis], t[4 + axis]}) >= limit - 1;
            };
            if (beyond(0, _tile->tile.grid().dataColumns()) || beyond(1, _tile->tile.grid().dataRows()))
                continue;
            const glm::dvec3 a = at(0), b = at(1), c = at(2);
            const glm::dvec3 solved = glm::inverse(glm::dmat3(b - a, c - a, -direction)) * (origin - a);
            if (std::min({solved.x, solved.y, 1.0 - solved.x - solved.y}) >= -1e-9 && solved.z >= 0.0)
                nearest = std::min(nearest, solved.z);
        }
        return nearest;
    }

    std::shared_ptr<const RoamTile> _tile;
    DiamondTree _tree;
};

TEST_P(GroundRay, MeetsWhatBruteForceMeets)
{
    Random random(4);
    int hits = 0, misses = 0;
    for (int i = 0; i < 400; ++i)
    {
        const glm::dvec3 origin = placeAt(random, 700.0 * (random.unit() - 0.4));
        const glm::dvec3 direction = glm::normalize(placeAt(random, 900.0 * (random.unit() - 0.5)) - origin);
        const double expected = bruteForce(origin, direction);
        const auto hit = hitGround(*_tile, origin, direction, 1e9);
        ASSERT_EQ(hit.has_value(), expected < 1e299) << "ray " << i;
        if (!hit)
        {
            ++misses;
            continue;
        }
        ++hits;
        EXPECT_NEAR(hit->distanceM, expected, 1e-6) << "ray " << i;
        EXPECT_NEAR(glm::distance(hit->position, origin), expected, 1e-6);
        EXPECT_NEAR(glm::length(hit->normal), 1.0, 1e-12);
        EXPECT_FALSE(hitGround(*_tile, origin, direction, 0.999 * expected)) << "beyond what was asked";
    }
    EXPECT_GT(hits, 100);
    EXPECT_GT(misses, 30);
}

TEST_P(GroundRay, StraightDownIsTheGroundThere)
{
    Random random(6);
    for (int i = 0; i < 300; ++i)
    {
        const glm::dvec3 origin = placeAt(random, 2000.0);
        const auto ground = groundAt(_tile->tile, origin.x, origin.y);
        const auto hit = hitGround(*_tile, origin, {0.0, 0.0, -1.0}, 1e5);
        ASSERT_EQ(ground.has_value(), hit.has_value());
        if (!hit) continue;
        EXPECT_NEAR(hit->position.z, ground->position.z, 1e-6);
    }
}

TEST_P(GroundRay, SkyAndBackAreEmpty)
{
    Random random(8);
    const glm::dvec3 origin = placeAt(random, 3000.0);
    EXPECT_FALSE(hitGround(*_tile, origin, {0.0, 0.0, 1.0}, 1e9));
    EXPECT_FALSE(hitGround(*_tile, origin, {1.0, 0.0, 0.0}, 1e9));
    EXPECT_FALSE(hitGround(*_tile, {1e7, 1e7, 500.0}, {0.0, 0.0, -1.0}, 1e9));
}

INSTANTIATE_TEST_SUITE_P(Placements, GroundRay, testing::Bool(),
                         [](const auto& given) { return given.param ? "curved" : "planar"; });

} // namespace
