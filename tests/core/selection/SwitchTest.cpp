// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include <osgPMObjects/core/selection/Switch.h>

#include "Random.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::Random;

constexpr float kStepS = 0.125f;

SwitchSettings settingsOf(SwitchMethod method, BlendProfile profile = BlendProfile::cross)
{
    return {method, profile, 1.0f, 0.0f}; // eight steps, no stagger
}

/// Steps one object towards targets.
struct Object
{
    SwitchSettings settings;
    SwitchState state = SwitchState::at(0);
    std::uint32_t number = 0;

    DrawnLevels to(std::uint32_t target, float alpha = 1.0f)
    {
        const DrawnLevels drawn = advanceSwitch(state, target, kStepS, alpha, number, settings);
        EXPECT_TRUE(isSwitchState(state));
        return drawn;
    }
};

/// Returns the sum of the alphas with which a level is drawn.
float alphaOf(const DrawnLevels& drawn, std::uint32_t level)
{
    return (drawn.first.level == level ? drawn.first.alpha : 0.0f) +
           (drawn.second.level == level ? drawn.second.alpha : 0.0f);
}

TEST(Switch, SettingsThatCannotBePlayedAreToldFrom)
{
    EXPECT_TRUE(checkSettings(SwitchSettings{}));
    for (const float wrong : {0.0f, -1.0f, std::nanf(""), std::numeric_limits<float>::infinity()})
        EXPECT_FALSE(checkSettings({.durationS = wrong})) << wrong;
    EXPECT_TRUE(checkSettings({.staggerS = 0.0f}));
    EXPECT_FALSE(checkSettings({.staggerS = -0.1f}));
    for (const float wrong : {std::nanf(""), std::numeric_limits<float>::infinity()})
        EXPECT_FALSE(checkSettings({.staggerS = wrong})) << wrong;
}

TEST(Switch, DiscreteContinuousAndAlphaChangeAtOnce)
{
    for (const SwitchMethod method : {SwitchMethod::discrete, SwitchMethod::continuous, SwitchMethod::alpha})
    {
        Object object{settingsOf(method)};
        const DrawnLevels drawn = object.to(7, 0.25f);
        EXPECT_EQ(drawn.first.level, 7u);
        EXPECT_EQ(drawn.first.alpha, 0.25f);
        EXPECT_EQ(drawn.second.alpha, 0.0f);
        EXPECT_FALSE(object.to(7, 0.0f).isDrawn());
    }
}

TEST(Switch, ACrossBlendGoesEvenlyFromOneToTheOther)
{
    Object object{settingsOf(SwitchMethod::blend)};
    for (int step = 0; step < 8; ++step)
    {
        const DrawnLevels drawn = object.to(5);
        EXPECT_FLOAT_EQ(alphaOf(drawn, 0), 1.0f - 0.125f * step);
        EXPECT_FLOAT_EQ(alphaOf(drawn, 5), 0.125f * step);
    }
    const DrawnLevels end = object.to(5);
    EXPECT_EQ(end.first.level, 5u);
    EXPECT_EQ(end.first.alpha, 1.0f);
    EXPECT_EQ(end.second.alpha, 0.0f);
    EXPECT_FALSE(object.state.isSwitching());
}

TEST(Switch, AnOverBlendAlwaysHasAnOpaqueLevelThatComesFirst)
{
    Object object{settingsOf(SwitchMethod::blend, BlendProfile::over)};
    const std::vector<float> oldLevel = {1, 1, 1, 1, 1, 0.75f, 0.5f, 0.25f, 0};
    const std::vector<float> newLevel = {0, 0.25f, 0.5f, 0.75f, 1, 1, 1, 1, 1};
    for (std::size_t step = 0; step < oldLevel.size(); ++step)
    {
        const DrawnLevels drawn = object.to(5);
        EXPECT_EQ(drawn.first.alpha, 1.0f);
        EXPECT_FLOAT_EQ(alphaOf(drawn, 0), oldLevel[step]) << step;
        EXPECT_FLOAT_EQ(alphaOf(drawn, 5), newLevel[step]) << step;
    }
}

TEST(Switch, AGeomorphDrawsTheFinerLevelAndMovesItTowardsTheCoarser)
{
    Object object{settingsOf(SwitchMethod::geomorph)};
    for (int step = 0; step < 8; ++step)
    { // 0 is finer than 5: it goes there, and is then replaced by what it looks like
        const DrawnLevels drawn = object.to(5);
        EXPECT_EQ(drawn.first.level, 0u);
        EXPECT_EQ(drawn.coarser, 5u);
        EXPECT_FLOAT_EQ(drawn.morph, 0.125f * step);
        EXPECT_EQ(drawn.second.alpha, 0.0f);
    }
    DrawnLevels drawn = object.to(5);
    EXPECT_EQ(drawn.first.level, 5u);
    EXPECT_EQ(drawn.morph, 0.0f);
    drawn = object.to(2); // finer: begins as it looked
    EXPECT_EQ(drawn.first.level, 2u);
    EXPECT_EQ(drawn.coarser, 5u);
    EXPECT_EQ(drawn.morph, 1.0f);
    EXPECT_FLOAT_EQ(object.to(2).morph, 0.875f);
}

TEST(Switch, RunsBackFromWhereItIsWhenTheOldLevelIsWantedAgain)
{
    for (const BlendProfile profile : {BlendProfile::cross, BlendProfile::over})
    {
        Object object{settingsOf(SwitchMethod::blend, profile)};
        std::vector<float> there;
        for (int step = 0; step < 4; ++step)
            there.push_back(alphaOf(object.to(5), 5));
        for (int step = 2; step >= 0; --step)
            EXPECT_FLOAT_EQ(alphaOf(object.to(0), 5), there[static_cast<std::size_t>(step)]);
        EXPECT_FALSE(object.state.isSwitching());
    }
}

TEST(Switch, FinishesBeforeItGoesOnToAThirdLevel)
{
    Object object{settingsOf(SwitchMethod::blend)};
    for (int step = 0; step < 3; ++step)
        object.to(5);
    for (int step = 3; step < 8; ++step)
    {
        const DrawnLevels drawn = object.to(9);
        EXPECT_FLOAT_EQ(alphaOf(drawn, 5), 0.125f * step);
        EXPECT_EQ(alphaOf(drawn, 9), 0.0f);
    }
    EXPECT_EQ(object.to(9).first.level, 5u);
    object.to(9);
    EXPECT_FLOAT_EQ(alphaOf(object.to(9), 9), 0.125f);
}

TEST(Switch, ATargetThatGoesAwayBeforeTheSwitchBeganLeavesNoTrace)
{
    Object object{settingsOf(SwitchMethod::blend)};
    object.settings.staggerS = 10.0f;
    object.number = 1; // waits 6.2 s
    for (int step = 0; step < 30; ++step)
        EXPECT_EQ(object.to(5).first.level, 0u);
    object.to(0);
    for (int step = 0; step < 30; ++step) // the wait begins anew
        EXPECT_EQ(alphaOf(object.to(5), 5), 0.0f);
    EXPECT_FALSE(object.state.isSwitching());
}

TEST(Switch, AnObjectThatWasNotDrawnComesBackAtItsTarget)
{
    Object object{settingsOf(SwitchMethod::blend)};
    for (int step = 0; step < 3; ++step)
        object.to(5);
    EXPECT_FALSE(object.to(9, 0.0f).isDrawn());
    const DrawnLevels drawn = object.to(9, 0.1f);
    EXPECT_EQ(drawn.first.level, 9u);
    EXPECT_FLOAT_EQ(drawn.first.alpha, 0.1f);
    EXPECT_EQ(drawn.second.alpha, 0.0f);
}

TEST(Switch, TheAlphaRangeFadesBothLevels)
{
    Object object{settingsOf(SwitchMethod::blend, BlendProfile::over)};
    object.to(5, 0.5f);
    const DrawnLevels drawn = object.to(5, 0.5f);
    EXPECT_FLOAT_EQ(drawn.first.alpha, 0.5f);
    EXPECT_FLOAT_EQ(drawn.second.alpha, 0.125f);
}

/// Returns the largest change of an alpha or of a morph from step to step, while targets change at
/// random.
float largestJump(const SwitchSettings& settings, std::uint64_t seed)
{
    Random random(seed);
    Object object{settings};
    object.number = 3;
    std::map<std::uint32_t, float> last = {{0, 1.0f}};
    float largest = 0.0f;
    std::uint32_t target = 0;
    for (int step = 0; step < 5000; ++step)
    {
        if (random.below(6) == 0) target = random.below(4);
        const DrawnLevels drawn = object.to(target);
        std::map<std::uint32_t, float> now;
        for (std::uint32_t level = 0; level < 4; ++level)
            now[level] = alphaOf(drawn, level);
        if (settings.method == SwitchMethod::geomorph) // what it looks like: a share of either level
        {
            now = {};
            now[drawn.first.level] += 1.0f - drawn.morph;
            now[drawn.coarser] += drawn.morph;
        }
        for (std::uint32_t level = 0; level < 4; ++level)
            largest = std::max(largest, std::abs(now[level] - last[level]));
        last = now;
    }
    return largest;
}

TEST(Switch, NoStepOfAnySwitchJumpsWhateverTheTargetsDo)
{
    constexpr float kRounding = 1e-5f;
    EXPECT_LE(largestJump(settingsOf(SwitchMethod::blend), 1), kStepS + kRounding);
    EXPECT_LE(largestJump(settingsOf(SwitchMethod::blend, BlendProfile::over), 2), 2 * kStepS + kRounding);
    EXPECT_LE(largestJump(settingsOf(SwitchMethod::geomorph), 3), kStepS + kRounding);
    SwitchSettings staggered = settingsOf(SwitchMethod::blend);
    staggered.staggerS = 0.5f;
    EXPECT_LE(largestJump(staggered, 4), kStepS + kRounding);
    EXPECT_EQ(largestJump(settingsOf(SwitchMethod::discrete), 5), 1.0f); // the control
}

/// Returns the most objects of a thousand that begin a blend in one step, after all were given another level.
int mostBeginningsInAStep(float staggerS)
{
    std::vector<int> begun(20, 0);
    for (std::uint32_t number = 0; number < 1000; ++number)
    {
        Object object{settingsOf(SwitchMethod::blend)};
        object.settings.staggerS = staggerS;
        object.number = number;
        object.to(0);
        for (int& count : begun)
        {
            const bool was = object.state.isSwitching();
            object.to(5);
            count += !was && object.state.isSwitching();
        }
    }
    return *std::max_element(begun.begin(), begun.end());
}

TEST(Switch, BlendsOfDifferentObjectsAreSpreadOverTheStagger)
{
    EXPECT_LE(mostBeginningsInAStep(8 * kStepS), 1000 / 8 + 15);
    EXPECT_EQ(mostBeginningsInAStep(0.0f), 1000);
}

TEST(Switch, StaggersFromTheVeryFirstSwitch)
{
    Object object{settingsOf(SwitchMethod::blend)};
    object.settings.staggerS = 4.0f;
    object.number = 1;
    object.to(5);
    EXPECT_FALSE(object.state.isSwitching());
}

} // namespace
