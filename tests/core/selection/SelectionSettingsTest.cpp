// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include <osgPMObjects/core/selection/Priority.h>
#include <osgPMObjects/core/selection/SceneSelector.h>
#include <osgPMObjects/core/selection/SelectionSettings.h>

namespace
{

using namespace osgPMObjects::core;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const double kNoNumbers[] = {std::nan(""), kInfinity, -kInfinity};

/// Returns the last part of the field that checkSettings() complains of after `change`; empty: none.
template<class Change>
std::string refusedAfter(const Change& change)
{
    SelectionSettings settings;
    change(settings);
    const auto outcome = checkSettings(settings, 100);
    if (outcome) return "";
    EXPECT_FALSE(outcome.error().remedy.empty());
    return outcome.error().place.substr(outcome.error().place.find('.') + 1);
}

TEST(SelectionSettings, NumbersThatAreNaNInfiniteOrOutOfRangeAreRefused)
{
    EXPECT_EQ(refusedAfter([](SelectionSettings&) {}), "");
    for (const double wrong : {kNoNumbers[0], kNoNumbers[1], kNoNumbers[2], -1.0})
    {
        const auto inFloat = static_cast<float>(wrong);
        EXPECT_EQ(refusedAfter([&](SelectionSettings& s) { s.referenceM = wrong; }), "referenceM");
        EXPECT_EQ(refusedAfter([&](SelectionSettings& s) { s.trianglePx = wrong; }), "trianglePx");
        EXPECT_EQ(refusedAfter([&](SelectionSettings& s) { s.tolerancePx = wrong; }), "tolerancePx");
        EXPECT_EQ(refusedAfter([&](SelectionSettings& s) { s.band = wrong; }), "band");
        EXPECT_EQ(refusedAfter([&](SelectionSettings& s) { s.continuousBand = wrong; }), "continuousBand");
        EXPECT_EQ(refusedAfter([&](SelectionSettings& s) { s.weights.normal = inFloat; }), "weights.normal");
        EXPECT_EQ(refusedAfter([&](SelectionSettings& s) { s.weights.texCoord = inFloat; }),
                  "weights.texCoord");
        EXPECT_EQ(refusedAfter([&](SelectionSettings& s) { s.weights.colour = inFloat; }), "weights.colour");
    }
    EXPECT_EQ(refusedAfter([](SelectionSettings& s) { s.trianglePx = 0.0; }), "trianglePx");
    EXPECT_EQ(refusedAfter([](SelectionSettings& s) { s.tolerancePx = 0.0; }), "tolerancePx");
}

TEST(SelectionSettings, AlphaRangesFadeOutOrNever)
{
    const auto refused = [](double fadeM, double goneM) {
        return !refusedAfter([&](SelectionSettings& s) { s.alpha = {fadeM, goneM}; }).empty();
    };
    EXPECT_FALSE(refused(0.0, 100.0));
    EXPECT_FALSE(refused(100.0, 100.0));
    EXPECT_FALSE(refused(kInfinity, kInfinity));
    EXPECT_FALSE(refused(100.0, kInfinity));
    EXPECT_EQ((AlphaRange{100.0, kInfinity}.alphaAt(200.0)), 1.0f) << "never fades, and is no NaN";
    EXPECT_TRUE(refused(kInfinity, 100.0));
    EXPECT_TRUE(refused(-1.0, 100.0));
    EXPECT_TRUE(refused(0.0, 0.0));
    EXPECT_TRUE(refused(std::nan(""), 100.0));
    EXPECT_TRUE(refused(100.0, std::nan("")));
}

TEST(SelectionSettings, BoundariesAreFiniteForEveryMethodWithRows)
{
    for (const double wrong : kNoNumbers)
    {
        EXPECT_FALSE(isRanges({{1.0, wrong}, {0, 1, 2}})) << wrong;
        EXPECT_FALSE(isRanges({{wrong, 1.0}, {0, 1, 2}})) << wrong;
        EXPECT_FALSE(isOverlappingRanges({{{1.0, wrong}}, {0, 1}})) << wrong;
        EXPECT_FALSE(isOverlappingRanges({{{wrong, 1.0}}, {0, 1}})) << wrong;
        EXPECT_FALSE(isAreaRows({{wrong, 1.0}, {0, 1, 2}})) << wrong;
        EXPECT_FALSE(isAreaRows({{2.0, wrong}, {0, 1, 2}})) << wrong;
    }
}

TEST(SceneBudgetSettings, CostsAndBandOutsideTheirRangesAreRefused)
{
    EXPECT_TRUE(checkSettings(SceneBudgetSettings{}));
    for (const double wrong : {kNoNumbers[0], kNoNumbers[1], kNoNumbers[2], -1.0, 1e10})
    {
        EXPECT_FALSE(checkSettings(SceneBudgetSettings{.cost = {.perTriangle = wrong}})) << wrong;
        EXPECT_FALSE(checkSettings(SceneBudgetSettings{.cost = {.perVertex = wrong}})) << wrong;
        EXPECT_FALSE(checkSettings(SceneBudgetSettings{.cost = {.perDraw = wrong}})) << wrong;
    }
    for (const double wrong : {kNoNumbers[0], kNoNumbers[1], kNoNumbers[2], 0.9})
        EXPECT_FALSE(checkSettings(SceneBudgetSettings{.band = wrong})) << wrong;
    const CostModel dearest{CostModel::kMostEach, CostModel::kMostEach, CostModel::kMostEach};
    EXPECT_TRUE(checkSettings(SceneBudgetSettings{.cost = dearest}));
    constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();
    EXPECT_GT(dearest.of(kMost, kMost), dearest.of(kMost - 1, kMost)) << "does not overflow";
}

TEST(AttentionRule, GainsAndAnglesOutsideTheirRangesAreRefused)
{
    EXPECT_TRUE(checkSettings(AttentionRule{}));
    EXPECT_TRUE(checkSettings(AttentionRule{.gazeInnerDeg = 5.0, .gazeOuterDeg = 40.0}));
    EXPECT_FALSE(checkSettings(AttentionRule{.gazeInnerDeg = 40.0, .gazeOuterDeg = 5.0}));
    EXPECT_FALSE(checkSettings(AttentionRule{.gazeOuterDeg = 181.0}));
    EXPECT_FALSE(checkSettings(AttentionRule{.attendedGain = 0.5}));
    EXPECT_FALSE(checkSettings(AttentionRule{.peripheralGain = 0.0}));
    EXPECT_FALSE(checkSettings(AttentionRule{.peripheralGain = 1.5}));
    EXPECT_FALSE(checkSettings(AttentionRule{.gaze = {0.0, 0.0, -2.0}}));
    for (const double wrong : kNoNumbers)
    {
        EXPECT_FALSE(checkSettings(AttentionRule{.attendedGain = wrong})) << wrong;
        EXPECT_FALSE(checkSettings(AttentionRule{.peripheralGain = wrong})) << wrong;
        EXPECT_FALSE(checkSettings(AttentionRule{.gazeInnerDeg = wrong})) << wrong;
        EXPECT_FALSE(checkSettings(AttentionRule{.gazeOuterDeg = wrong})) << wrong;
        EXPECT_FALSE(checkSettings(AttentionRule{.gaze = {wrong, 0.0, 0.0}})) << wrong;
    }
}

} // namespace
