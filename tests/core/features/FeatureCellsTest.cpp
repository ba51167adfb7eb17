// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/features/FeatureCover.h>

#include "SyntheticField.h"

namespace
{

using namespace osgTerrainROAM::core;
using testsupport::Random;

constexpr double kSideM = 3000.0;

glm::dvec2 randomPlace(Random& random, const glm::dvec2& origin)
{
    return origin + kSideM * glm::dvec2(random.unit(), random.unit());
}

/// Crooked roads and rivers, and star-shaped fields with holes, about `origin`.
std::vector<GroundFeature> randomFeatures(std::uint64_t seed, const glm::dvec2& origin)
{
    Random random(seed);
    std::vector<GroundFeature> features;
    for (int i = 0; i < 24; ++i)
    {
        GroundFeature line;
        line.style.kind = i % 3 ? FeatureKind::road : FeatureKind::river;
        line.style.widthM = 2.0 + 20.0 * random.unit();
        glm::dvec2 at = randomPlace(random, origin);
        line.paths.emplace_back();
        for (int k = 0; k < 20; ++k, at += 160.0 * (glm::dvec2(random.unit(), random.unit()) - 0.5))
            line.paths[0].push_back(at);
        features.push_back(line);
    }
    for (int i = 0; i < 12; ++i)
    {
        GroundFeature area;
        area.isArea = true;
        area.style.kind = i % 4 ? FeatureKind::field : FeatureKind::river;
        const glm::dvec2 middle = randomPlace(random, origin);
        for (const double radius : {300.0, 90.0})
        {
            area.paths.emplace_back();
            for (int k = 0; k < 30; ++k)
            {
                const double angle = k * 0.2094395102;
                area.paths.back().push_back(middle + radius * (0.5 + 0.5 * random.unit()) *
                                                         glm::dvec2(std::cos(angle), std::sin(angle)));
            }
        }
        features.push_back(area);
    }
    return features;
}

double distanceToSegment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b)
{
    const glm::dvec2 way = b - a;
    const double share = std::clamp(glm::dot(p - a, way) / glm::dot(way, way), 0.0, 1.0);
    return glm::distance(p, a + share * way);
}

/// Brute force: distance over all segments of all features, without cells.
double bruteRoadEdge(const std::vector<GroundFeature>& features, const glm::dvec2& place)
{
    double nearest = 1e9;
    for (const GroundFeature& feature : features)
        if (feature.style.kind == FeatureKind::road && !feature.isArea)
            for (const auto& path : feature.paths)
                for (std::size_t i = 0; i + 1 < path.size(); ++i)
                    nearest = std::min(nearest, distanceToSegment(place, path[i], path[i + 1]) -
                                                    0.5 * feature.style.widthM);
    return nearest;
}

/// Even-odd over whole rings, and the distance of the position from the nearest ring.
std::pair<bool, double> bruteField(const GroundFeature& feature, const glm::dvec2& place)
{
    bool inside = false;
    double nearest = 1e9;
    for (const auto& ring : feature.paths)
        for (std::size_t i = 0; i < ring.size(); ++i)
        {
            const glm::dvec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
            nearest = std::min(nearest, distanceToSegment(place, a, b));
            if ((a.y > place.y) != (b.y > place.y) &&
                a.x + (place.y - a.y) / (b.y - a.y) * (b.x - a.x) > place.x)
                inside = !inside;
        }
    return {inside, nearest};
}

/// The largest difference between cells and brute force, metres, at random positions.
double worstRoadError(const FeatureCells& cells, const std::vector<GroundFeature>& features,
                      const glm::dvec2& origin)
{
    Random random(99);
    double worst = 0.0;
    for (int i = 0; i < 20000; ++i)
    {
        const glm::dvec2 place = randomPlace(random, origin);
        const double expected = std::min(bruteRoadEdge(features, place), FeatureCells::kReachM);
        worst = std::max(worst, std::abs(featureCover(cells, place, 0.01).roadEdgeM - expected));
    }
    return worst;
}

} // namespace

TEST(FeatureCells, GiveTheDistanceThatAllSegmentsGive)
{
    for (const glm::dvec2 origin : {glm::dvec2(-1500.0, -1500.0), glm::dvec2(58000.0, -61000.0)})
    {
        const auto features = randomFeatures(1, origin);
        const auto cells = FeatureCells::build(features);
        ASSERT_TRUE(cells);
        EXPECT_TRUE(cells->isConsistent());
        EXPECT_LT(worstRoadError(*cells, features, origin), 1e-4)
            << "to a tenth of a millimetre, 60 km away too";
    }
}

TEST(FeatureCells, AListThatLacksOneRoadIsFoundOut)
{
    const glm::dvec2 origin(-1500.0, -1500.0);
    const auto features = randomFeatures(1, origin);
    auto fewer = features;
    fewer.erase(fewer.begin() + 4);
    const auto cells = FeatureCells::build(fewer);
    ASSERT_TRUE(cells);
    EXPECT_GT(worstRoadError(*cells, features, origin), 1.0);
}

TEST(FeatureCells, AreasAreInsideWhereEvenOddOfTheWholeRingsSays)
{
    for (const glm::dvec2 origin : {glm::dvec2(-1500.0, -1500.0), glm::dvec2(58000.0, -61000.0)})
        for (const auto& feature : randomFeatures(7, origin))
        {
            if (!feature.isArea) continue;
            const auto cells = FeatureCells::build({feature});
            ASSERT_TRUE(cells);
            Random random(5);
            int inside = 0;
            for (int i = 0; i < 4000; ++i)
            {
                const glm::dvec2 place =
                    feature.paths[0][0] + 900.0 * (glm::dvec2(random.unit(), random.unit()) - 0.5);
                const auto [expected, nearest] = bruteField(feature, place);
                const FeatureCover cover = featureCover(*cells, place, 0.01);
                const float share = feature.style.kind == FeatureKind::river
                                        ? cover.river
                                        : cover.crops[0] + cover.crops[1] + cover.crops[2] + cover.crops[3];
                inside += expected;
                if (nearest < 0.02) continue;
                EXPECT_EQ(share, expected ? 1.0f : 0.0f) << place.x << ' ' << place.y;
            }
            EXPECT_GT(inside, 100);
        }
}

TEST(FeatureCells, ALineThinnerThanTheFilterIsItsShareOfIt)
{
    GroundFeature road;
    road.style.widthM = 6.0;
    road.paths = {{{0.0, 0.0}, {1000.0, 0.0}}};
    const auto cells = FeatureCells::build({road});
    ASSERT_TRUE(cells);
    for (const double filterM : {0.1, 1.0, 6.0, 12.0, 30.0})
    {
        EXPECT_NEAR(featureCover(*cells, {500.0, 0.0}, filterM).asphalt, std::min(1.0, 6.0 / filterM), 1e-5);
        // The sum over all positions across it is its width: 6 m.
        double sum = 0.0;
        for (double y = -40.0; y < 40.0; y += 0.01)
            sum += 0.01 * featureCover(*cells, {500.0, y}, filterM).asphalt;
        EXPECT_NEAR(sum, 6.0, 0.05) << filterM;
    }
}

TEST(FeatureCells, AFieldWhoseCropIsKnownBearsIt)
{
    int cereals = 0, known = 0;
    for (int i = 0; i < 60; ++i)
    {
        const glm::dvec2 at(997.0 * i, 613.0 * i);
        GroundFeature field;
        field.isArea = true;
        field.style.kind = FeatureKind::field;
        field.paths = {{at, at + glm::dvec2(100.0, 0.0), at + glm::dvec2(0.0, 100.0)}};
        cereals += featureCover(*FeatureCells::build({field}), at + 20.0, 1.0).crops[0] == 1.0f;
        field.style.isCropKnown = true;
        known += featureCover(*FeatureCells::build({field}), at + 20.0, 1.0).crops[0] == 1.0f;
    }
    EXPECT_EQ(known, 60);
    EXPECT_GT(cereals, 25);
    EXPECT_LT(cereals, 55) << "others bear row crops";
}

TEST(FeatureCells, CrowdedMapsGetSmallerCells)
{
    std::vector<GroundFeature> crowd;
    for (int i = 0; i < 400; ++i)
    {
        GroundFeature road;
        road.paths = {{{5.0 * i, 0.0}, {5.0 * i, 2000.0}}};
        crowd.push_back(road);
    }
    EXPECT_EQ(FeatureCells::build(crowd)->cellM, 32.0);
    EXPECT_EQ(FeatureCells::build({crowd[0]})->cellM, 64.0);
}

TEST(FeatureCells, MoreThanATextureNumbersIsRefusedBeforeItFillsTheMemory)
{
    std::vector<GroundFeature> many;
    for (int i = 0; i < 4000; ++i)
    {
        GroundFeature road;
        road.paths = {{{0.0, 10.0 * i}, {100000.0, 10.0 * i}}};
        many.push_back(road);
    }
    const auto cells = FeatureCells::build(many);
    ASSERT_FALSE(cells);
    EXPECT_NE(cells.error().what.find("16 million"), std::string::npos);
}

TEST(FeatureCells, WhatReachesTooFarIsRefused)
{
    GroundFeature road;
    road.paths = {{{0.0, 0.0}, {9.0e6, 9.0e6}}};
    const auto cells = FeatureCells::build({road});
    ASSERT_FALSE(cells);
    EXPECT_NE(cells.error().remedy.find("-clipsrc"), std::string::npos);
    EXPECT_EQ(FeatureCells::build({})->cells.size(), 0u);
}
