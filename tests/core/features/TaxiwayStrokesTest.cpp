// SPDX-License-Identifier: Apache-2.0
// Where the yellow lines of taxiways lie.
#include "TaxiwayStrokes.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "FeatureShapes.h"
#include "FeatureTags.h"

namespace
{

using namespace osgTerrainROAM::core;

constexpr double kHoldingLineM = 0.15; ///< half the width of its lines

/// East of the origin, so long.
RunwayFrame runwayOf(double lengthM)
{
    return {{0.0, 0.0}, {lengthM, 0.0}, 30.0, ""};
}

using Tags = std::map<std::string, std::string>;

GroundFeature featureOf(const Tags& tags, std::vector<glm::dvec2> path, bool isArea = false)
{
    const auto style =
        featureStyle([&](const char* name) { return tags.count(name) ? tags.at(name) : std::string(); }, "");
    return {style.value_or(FeatureStyle{}), isArea, {std::move(path)}};
}

/// The strokes of holding positions: those that are wider than the middle line.
std::vector<Stroke> acrossOf(const std::vector<Stroke>& strokes)
{
    std::vector<Stroke> across;
    for (const Stroke& stroke : strokes)
        if (stroke.halfWidthM == kHoldingLineM) across.push_back(stroke);
    return across;
}

/// Northings of the whole lines, and the mean of the dashes', of the only holding position north of a runway.
struct Holding
{
    std::vector<double> wholeM;
    double dashesM = 0.0;
    int dashes = 0;
};

Holding holdingOf(const std::vector<Stroke>& strokes, double widthM)
{
    Holding holding;
    for (const Stroke& stroke : acrossOf(strokes))
    {
        if (glm::distance(stroke.a, stroke.b) > widthM - 1e-6)
        {
            holding.wholeM.push_back(stroke.a.y);
            continue;
        }
        holding.dashesM += stroke.a.y;
        ++holding.dashes;
    }
    std::sort(holding.wholeM.begin(), holding.wholeM.end());
    holding.dashesM /= std::max(holding.dashes, 1);
    return holding;
}

TEST(TaxiwayStrokes, OneHoldsAsFarFromARunwayAsItsLengthAsks)
{
    for (const auto& [lengthM, awayM] : {std::pair{700.0, 30.0}, {1000.0, 40.0}, {2500.0, 75.0}})
    {
        const std::vector<RunwayFrame> runways{runwayOf(lengthM)};
        const Holding holding = holdingOf(taxiwayStrokes({{300, 0}, {300, 200}}, 15.0, runways), 15.0);
        ASSERT_EQ(holding.wholeM.size(), 2U) << lengthM;
        EXPECT_NEAR(holding.wholeM[0], awayM + 0.3, 1.0);
        EXPECT_NEAR(holding.wholeM[1], awayM + 0.9, 1.0);
        EXPECT_LT(holding.dashesM, holding.wholeM[0]) << "the dashes lie towards the runway";
        EXPECT_EQ(holding.dashes, 2 * 8);
    }
}

TEST(TaxiwayStrokes, OneThatCrossesARunwayHasAHoldingPositionOnBothSides)
{
    const std::vector<RunwayFrame> runways{runwayOf(2500.0)};
    const auto strokes = acrossOf(taxiwayStrokes({{900, -300}, {900, 300}}, 15.0, runways));
    const auto south =
        std::count_if(strokes.begin(), strokes.end(), [](const Stroke& s) { return s.a.y < 0.0; });
    EXPECT_EQ(south, 18);
    EXPECT_EQ(strokes.size(), 36U);
    // The mutations: one that ends before the runway, and one without a runway, have none.
    EXPECT_TRUE(acrossOf(taxiwayStrokes({{900, 60}, {900, 300}}, 15.0, runways)).empty());
    EXPECT_TRUE(acrossOf(taxiwayStrokes({{900, -300}, {900, 300}}, 15.0, {})).empty());
}

TEST(TaxiwayStrokes, AShortOneHoldsBeforeItsEnd)
{
    const std::vector<RunwayFrame> runways{runwayOf(2500.0)};
    const Holding holding = holdingOf(taxiwayStrokes({{300, 0}, {300, 60}}, 15.0, runways), 15.0);
    ASSERT_EQ(holding.wholeM.size(), 2U);
    EXPECT_NEAR(holding.wholeM[1], 60.0 - 12.0 + 0.9, 1.5);
    EXPECT_TRUE(acrossOf(taxiwayStrokes({{300, 0}, {300, 38}}, 15.0, runways)).empty());
}

TEST(TaxiwayStrokes, TheLineIsRoundInBendsAndStaysOnThePavement)
{
    const std::vector<glm::dvec2> path{{0, 0}, {100, 0}, {100, 100}};
    const auto strokes = taxiwayStrokes(path, 12.0, {});
    double sharpestRad = 0.0, nearestM = 1e9;
    for (std::size_t i = 0; i < strokes.size(); ++i)
    {
        EXPECT_LT(std::min(std::abs(strokes[i].b.y), std::abs(strokes[i].b.x - 100.0)), 5.5);
        nearestM = std::min(nearestM, glm::distance(strokes[i].b, {100.0, 0.0}));
        if (i == 0) continue;
        EXPECT_EQ(strokes[i - 1].b, strokes[i].a) << "without a gap";
        const glm::dvec2 before = glm::normalize(strokes[i - 1].b - strokes[i - 1].a),
                         after = glm::normalize(strokes[i].b - strokes[i].a);
        sharpestRad = std::max(sharpestRad, std::acos(std::min(1.0, glm::dot(before, after))));
    }
    EXPECT_LT(sharpestRad, 0.35);
    EXPECT_GT(nearestM, 4.0) << "it cuts the corner";
    EXPECT_EQ(strokes.front().a, path.front());
    EXPECT_EQ(strokes.back().b, path.back());
}

TEST(TaxiwayStrokes, PavedTaxiwaysOfAMapHaveThemBelowTheRunway)
{
    const GroundFeature runway = featureOf({{"aeroway", "runway"}}, {{0, 0}, {2500, 0}});
    const auto yellowOf = [&](const Tags& tags)
    {
        const FeatureShapes shapes({runway, featureOf(tags, {{300, 0}, {300, 200}})});
        const auto isYellow = [](const Stroke& stroke) { return stroke.paint == FeatureCells::yellow; };
        // All of it lies first, so that the runway covers it.
        const auto end = std::find_if_not(shapes.strokes.begin(), shapes.strokes.end(), isYellow);
        EXPECT_EQ(std::count_if(end, shapes.strokes.end(), isYellow), 0);
        return end - shapes.strokes.begin();
    };
    for (const char* kind : {"taxiway", "taxilane", "parking_position"})
        EXPECT_GT(yellowOf({{"aeroway", kind}}), 1) << kind;
    EXPECT_EQ(yellowOf({{"aeroway", "taxiway"}, {"surface", "grass"}}), 0);
    EXPECT_EQ(yellowOf({{"highway", "service"}}), 0);
}

TEST(TaxiwayStrokes, ARunwayThatAMapHasAsLineAndAreaIsPaintedOnce)
{
    const Tags runway{{"aeroway", "runway"}};
    const GroundFeature line = featureOf(runway, {{0, 0}, {2500, 0}}),
                        taxiway = featureOf({{"aeroway", "taxiway"}}, {{300, 0}, {300, 200}});
    const auto areaAt = [&](double northM)
    {
        return featureOf(
            runway, {{-5, northM - 23}, {2505, northM - 23}, {2505, northM + 23}, {-5, northM + 23}}, true);
    };
    const std::size_t once = FeatureShapes({line, taxiway}).strokes.size();
    EXPECT_EQ(FeatureShapes({line, areaAt(2.0), taxiway}).strokes.size(), once);
    EXPECT_EQ(FeatureShapes({areaAt(2.0), line, taxiway}).strokes.size(), once);
    // The mutations: another runway beside it, and one that crosses its middle.
    EXPECT_GT(FeatureShapes({line, areaAt(-400.0), taxiway}).strokes.size(), once);
    const GroundFeature crossing =
        featureOf(runway, {{1230, -1200}, {1270, -1200}, {1270, 1200}, {1230, 1200}}, true);
    EXPECT_GT(FeatureShapes({line, crossing, taxiway}).strokes.size(), once);
}

} // namespace
