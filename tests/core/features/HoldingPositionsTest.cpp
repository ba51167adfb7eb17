// SPDX-License-Identifier: Apache-2.0
// Where one waits before a runway, and what the signs there tell.
#include <gtest/gtest.h>

#include <osgTerrainROAM/core/features/HoldingPositions.h>

namespace
{

using namespace osgTerrainROAM::core;

GroundFeature lineOf(FeatureKind kind, std::vector<glm::dvec2> path)
{
    GroundFeature feature;
    feature.style.kind = kind;
    feature.style.widthM = 15.0;
    feature.paths = {std::move(path)};
    if (kind == FeatureKind::road) feature.style.taxiing = Taxiing::taxiway;
    return feature;
}

/// What signs tell on a taxiway over a runway eastward, with what designator the map has.
std::string toldOn(std::vector<glm::dvec2> taxiway, const std::string& designator = "09/27")
{
    GroundFeature runway = lineOf(FeatureKind::runway, {{0.0, 0.0}, {2500.0, 0.0}});
    runway.style.designator = designator;
    std::string told;
    for (const HoldingPosition& position :
         holdingPositions({runway, lineOf(FeatureKind::road, std::move(taxiway))}))
        told += (told.empty() ? "" : " ") + position.runways;
    return told;
}

TEST(HoldingPositions, TellTheRunwayAsWhoWaitsHasItsEnds)
{
    EXPECT_EQ(toldOn({{900, 0}, {900, 300}}), "27-09") << "from the north, 27's threshold lies to the left";
    EXPECT_EQ(toldOn({{900, -300}, {900, 0}}), "09-27");
    EXPECT_EQ(toldOn({{30, 0}, {30, 300}}), "09");
    EXPECT_EQ(toldOn({{2480, 0}, {2480, 300}}), "27");
    EXPECT_EQ(toldOn({{900, -300}, {900, 0}}, ""), "09-27") << "by its direction";
    EXPECT_EQ(toldOn({{900, 200}, {900, 300}}), "") << "leads to no runway";
}

TEST(HoldingPositions, HaveADirectionWhereAMapHasAPointTwice)
{
    const GroundFeature runway = lineOf(FeatureKind::runway, {{0.0, 0.0}, {2500.0, 0.0}}),
                        taxiway = lineOf(FeatureKind::road, {{300, 0}, {300, 48}, {300, 48}, {300, 60}});
    const auto positions = holdingPositions({runway, taxiway});
    ASSERT_EQ(positions.size(), 1U);
    EXPECT_NEAR(positions[0].away.y, 1.0, 1e-9);
    EXPECT_NEAR(positions[0].place.y, 48.0, 1.5);
}

TEST(HoldingPositions, LieOnTaxiwaysThatAMapHasInPieces)
{
    const GroundFeature runway = lineOf(FeatureKind::runway, {{0.0, 0.0}, {2500.0, 0.0}}),
                        first = lineOf(FeatureKind::road, {{300, 0}, {300, 50}}),
                        second = lineOf(FeatureKind::road, {{300, 50}, {300, 200}});
    const auto positions = holdingPositions({runway, first, second});
    ASSERT_EQ(positions.size(), 1U);
    EXPECT_NEAR(positions[0].place.y, 75.0, 1.0);
    EXPECT_NEAR(positions[0].away.y, 1.0, 1e-9);
    GroundFeature grass = second;
    grass.style.pavement = Pavement::earth;
    EXPECT_TRUE(holdingPositions({runway, grass}).empty());
}

} // namespace
