// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include <osgPMObjects/core/progressive/LevelMesh.h>

#include <osgPMObjects/ProgressiveNode>

#include "HandCull.h"
#include "ProgressiveSubject.h"

namespace
{

using namespace progressive;
using core::BlendProfile;
using core::SwitchMethod;
using handcull::cameraAt;
using handcull::Culled;

constexpr double kFrameS = 0.125; ///< four frames for a switch

const Subject& switchedSubject()
{
    static const Subject made = torusAndSheet();
    return made;
}

core::SwitchSettings by(SwitchMethod method, BlendProfile profile = BlendProfile::over)
{
    return {method, profile, 0.5F, 0.0F};
}

core::SelectionSettings always(std::uint32_t steps)
{
    core::SelectionSettings settings;
    settings.method = core::SelectionMethod::ranges;
    settings.ranges.steps = {steps};
    return settings;
}

std::uint64_t trianglesAt(std::uint32_t steps)
{
    return core::meshAfter(switchedSubject().mesh, switchedSubject().sequence, steps).faces.size();
}

/// An object and the camera that culls it, frame by frame.
struct Watched
{
    osg::ref_ptr<ProgressiveNode> node = new ProgressiveNode(switchedSubject().shape);
    osg::ref_ptr<osg::Camera> camera = cameraAt({8.0, -40.0, 3.0}, {8.0, 0.0, 0.0});
    unsigned frame = 0;

    explicit Watched(const core::SwitchSettings& switching, std::uint32_t steps = 0)
    {
        EXPECT_TRUE(node->setSwitching(switching));
        to(steps);
    }
    void to(std::uint32_t steps) { EXPECT_TRUE(node->setSelection(always(steps))); }
    Culled next() { return look(*camera, ++frame); }
    Culled look(osg::Camera& by, unsigned in) const
    {
        return handcull::cull(*node, by, in, false, kFrameS * in);
    }
    void lookFrom(double metres) const
    {
        camera->setViewMatrixAsLookAt({8.0, -metres, 3.0}, {8.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
    }
    ProgressiveViewStatistics statistics() const { return node->statistics().at(0); }
};

/// Counts how often an object begins a switch while its distance changes by 5 % to and fro.
int flipsAround(double metres, SwitchMethod method, const core::SelectionSettings& settings)
{
    Watched watched(by(method));
    EXPECT_TRUE(watched.node->setSelection(settings));
    watched.lookFrom(metres);
    watched.next();
    std::uint32_t aim = watched.statistics().switching.to;
    int flips = 0;
    for (int i = 0; i < 160; ++i)
    {
        watched.lookFrom(metres * (1.0 + 0.05 * std::sin(0.3 * i)));
        watched.next();
        flips += watched.statistics().switching.to != aim;
        aim = watched.statistics().switching.to;
    }
    return flips;
}

} // namespace

TEST(Switching, IsAtOnceUnlessItIsSet)
{
    const osg::ref_ptr<ProgressiveNode> node = new ProgressiveNode(switchedSubject().shape);
    EXPECT_EQ(node->switching().method, SwitchMethod::discrete);
    const auto wanted = by(SwitchMethod::geomorph);
    ASSERT_TRUE(node->setSwitching(wanted));
    core::SwitchSettings wrong = by(SwitchMethod::blend);
    wrong.durationS = 0.0F;
    EXPECT_FALSE(node->setSwitching(wrong));
    EXPECT_EQ(node->switching(), wanted) << "what is refused changes nothing";
    ProgressiveNodeSettings numbered = node->settings();
    numbered.number = 7;
    ASSERT_TRUE(node->setSettings(numbered));
    const osg::ref_ptr<ProgressiveNode> copy = new ProgressiveNode(*node);
    EXPECT_EQ(copy->switching(), wanted);
    EXPECT_EQ(copy->settings().number, 7u);
}

TEST(Switching, AMorphDrawsTheFinerLevelUntilItIsOver)
{
    Watched watched(by(SwitchMethod::geomorph), 100);
    watched.next();
    for (const std::uint32_t to : {500u, 100u})
    {
        watched.to(to);
        for (int frame = 0; frame < 4; ++frame)
        {
            EXPECT_EQ(watched.next().triangles(), trianglesAt(100)) << frame;
            const auto statistics = watched.statistics();
            EXPECT_EQ(statistics.method, SwitchMethod::geomorph);
            EXPECT_EQ(statistics.switching.to, to);
            EXPECT_EQ(statistics.switching.from, 600u - to);
            EXPECT_FLOAT_EQ(statistics.switching.progress, 0.25F * static_cast<float>(frame));
            EXPECT_EQ(statistics.secondTriangles, 0u);
        }
        EXPECT_EQ(watched.next().triangles(), trianglesAt(to));
        EXPECT_FALSE(watched.statistics().switching.isSwitching());
    }
}

TEST(Switching, ABlendDrawsBothLevelsUntilItIsOver)
{
    for (const auto profile : {BlendProfile::over, BlendProfile::cross})
    {
        Watched watched(by(SwitchMethod::blend, profile), 100);
        watched.next();
        for (const std::uint32_t to : {500u, 100u})
        {
            watched.to(to);
            watched.next();
            for (int frame = 1; frame < 4; ++frame)
            {
                const Culled culled = watched.next();
                const std::set<osg::Drawable*> parts(culled.drawables.begin(), culled.drawables.end());
                EXPECT_EQ(parts.size(), 4u);
                EXPECT_EQ(watched.statistics().triangles + watched.statistics().secondTriangles,
                          trianglesAt(100) + trianglesAt(500));
                std::uint64_t drawn = 0;
                for (osg::Drawable* const part : parts)
                    drawn += trianglesOf(std::vector{part}).size();
                EXPECT_EQ(drawn, trianglesAt(100) + trianglesAt(500));
            }
            EXPECT_EQ(watched.next().triangles(), trianglesAt(to));
            EXPECT_EQ(watched.statistics().secondTriangles, 0u);
        }
    }
}

/// The index buffer applies the steps of the switch once, as for a switch at once.
TEST(Switching, ABlendPlaysNoMoreStepsThanAHardSwitch)
{
    std::uint64_t hard = 0;
    for (const auto method : {SwitchMethod::discrete, SwitchMethod::blend})
    {
        Watched watched(by(method), 100);
        watched.next();
        watched.to(500);
        for (int frame = 0; frame < 8; ++frame)
            watched.next();
        if (method == SwitchMethod::discrete) hard = watched.statistics().played.steps;
        EXPECT_EQ(watched.statistics().played.steps, hard);
    }
}

TEST(Switching, ReleasesWhatItNeededWhenItIsOver)
{
    for (const auto method : {SwitchMethod::blend, SwitchMethod::geomorph})
    {
        Watched watched(by(method), 100);
        watched.next();
        watched.to(500);
        std::vector<osg::observer_ptr<osg::Drawable>> parts;
        watched.next();
        for (const auto& part : watched.next().drawables)
            parts.emplace_back(part);
        for (int frame = 0; frame < 6; ++frame)
            watched.next();
        const Culled atRest = watched.next();
        for (const auto& part : parts)
            EXPECT_TRUE(!part.valid() || std::find(atRest.drawables.begin(), atRest.drawables.end(),
                                                   part.get()) != atRest.drawables.end());
    }
}

TEST(Switching, GoesOnOnceAFrameForAllCamerasOfAGroup)
{
    Watched watched(by(SwitchMethod::geomorph), 500);
    const auto beside = cameraAt({8.0, -40.0, 3.0}, {9.0, 0.0, 0.0});
    watched.next();
    watched.look(*beside, watched.frame);
    watched.to(100);
    for (int frame = 0; frame < 4; ++frame)
    {
        const Culled first = watched.next();
        EXPECT_EQ(watched.look(*beside, watched.frame).drawables, first.drawables);
        ASSERT_EQ(watched.node->statistics().size(), 1u);
        EXPECT_EQ(watched.statistics().cameras, 2u);
        EXPECT_FLOAT_EQ(watched.statistics().switching.progress, 0.25F * static_cast<float>(frame));
    }
}

TEST(Switching, IsNotSeenByWhoDidNotLook)
{
    Watched watched(by(SwitchMethod::geomorph), 100);
    watched.next();
    watched.to(500);
    watched.next();
    watched.frame += 10;
    EXPECT_EQ(watched.next().triangles(), trianglesAt(500)) << "at rest after some frames out of sight";
    const auto another = cameraAt({8.0, -70.0, 3.0}, {8.0, 0.0, 0.0});
    watched.to(100);
    watched.next();
    EXPECT_EQ(watched.look(*another, watched.frame).triangles(), trianglesAt(100));
    EXPECT_FALSE(watched.node->statistics().at(1).switching.isSwitching()) << "another eye's first sight";
    EXPECT_TRUE(watched.statistics().switching.isSwitching());
}

TEST(Switching, WaitsByTheNumberOfTheObject)
{
    core::SwitchSettings settings = by(SwitchMethod::blend);
    settings.staggerS = 1.0F;
    unsigned lastFrame = 0;
    for (const std::uint32_t number : {0u, 2u, 1u})
    {
        Watched watched(settings, 100);
        ProgressiveNodeSettings numbered = watched.node->settings();
        numbered.number = number;
        ASSERT_TRUE(watched.node->setSettings(numbered));
        watched.next();
        watched.to(500);
        while (!watched.statistics().switching.isSwitching() && watched.frame < 20)
            watched.next();
        EXPECT_GT(watched.frame, lastFrame) << "shares of " << core::staggerShare(number);
        lastFrame = watched.frame;
    }
}

TEST(Switching, FlipsAtMostOnceFivePercentAroundAnyDistance)
{
    for (const auto method : {SwitchMethod::discrete, SwitchMethod::continuous, SwitchMethod::alpha,
                              SwitchMethod::blend, SwitchMethod::geomorph})
        for (double metres = 25.0; metres < 900.0; metres *= 1.13)
            EXPECT_LE(flipsAround(metres, method, {}), 1)
                << metres << " m, method " << static_cast<int>(method);
}

/// The count above can fail: without its band the selection flips.
TEST(SwitchingMutation, WithoutABandItFlips)
{
    core::SelectionSettings settings;
    settings.band = 1.0;
    int most = 0;
    for (double metres = 25.0; metres < 900.0; metres *= 1.13)
        most = std::max(most, flipsAround(metres, SwitchMethod::geomorph, settings));
    EXPECT_GT(most, 4);
}

TEST(Switching, AlphaFadesToNothingAndThenNothingIsDrawn)
{
    for (const auto method :
         {SwitchMethod::discrete, SwitchMethod::alpha, SwitchMethod::blend, SwitchMethod::geomorph})
    {
        Watched watched(by(method));
        core::SelectionSettings settings = always(100);
        settings.alpha = {100.0, 200.0};
        ASSERT_TRUE(watched.node->setSelection(settings));
        float last = 1.0F;
        for (const double metres : {90.0, 120.0, 150.0, 185.0})
        {
            watched.lookFrom(metres);
            EXPECT_FALSE(watched.next().drawables.empty()) << metres;
            EXPECT_LE(watched.statistics().selection.alpha, last);
            last = watched.statistics().selection.alpha;
        }
        EXPECT_LT(last, 0.2F);
        watched.lookFrom(230.0);
        EXPECT_TRUE(watched.next().drawables.empty());
        EXPECT_EQ(watched.statistics().selection.alpha, 0.0F);
        watched.lookFrom(90.0);
        EXPECT_EQ(watched.next().triangles(), trianglesAt(100));
    }
}

TEST(Switching, TellsOsgWhereNearAndFarAreOfWhatIsFaded)
{
    Watched watched(by(SwitchMethod::alpha));
    core::SelectionSettings settings = always(100);
    settings.alpha = {200.0, 400.0};
    ASSERT_TRUE(watched.node->setSelection(settings));
    watched.lookFrom(300.0);
    const Culled culled = handcull::cull(*watched.node, *watched.camera, 1, true);
    double fovy, aspect, nearM, farM;
    ASSERT_TRUE(culled.projection.getPerspective(fovy, aspect, nearM, farM));
    EXPECT_EQ(culled.drawables.size(), 4u) << "of two materials, depths and colours";
    EXPECT_GT(nearM, 250.0);
    EXPECT_LT(farM, 350.0);
}
