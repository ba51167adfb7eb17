// SPDX-License-Identifier: Apache-2.0
// Alpha ranges among other objects: a fading object is mixed with the background, and never with parts of
// itself.
#include <cmath>
#include <functional>

#include <osg/AlphaFunc>
#include <osg/Depth>

#include <osgOffscreen/ImageComparison>

#include "SwitchedAmongOthers.h"

namespace
{

using namespace switched;
using core::BlendProfile;
using core::SwitchMethod;

/// The object at an alpha of its alpha range.
Picture faded(const core::SwitchSettings& switching, double alpha,
              const std::function<void(Scene&)>& change = {},
              const osg::ref_ptr<ProgressiveShape>& shape = made())
{
    Scene scene(switching, shape);
    core::SelectionSettings settings = always(finerSteps());
    const osg::BoundingSphere ball = scene.node->drawable()->getBound();
    // The selection's sphere has its centre in the middle of the box, too.
    const double away = ball.radius() / std::sin(osg::DegreesToRadians(15.0));
    settings.alpha = {away - 1.0 + alpha, away + alpha};
    EXPECT_TRUE(scene.node->setSelection(settings));
    if (change) change(scene);
    const Picture picture = scene.stage()->after(kFrameS);
    EXPECT_NEAR(scene.node->statistics().at(0).selection.alpha, alpha, 1e-3);
    return picture;
}

/// Returns how much an image differs from the object mixed with the background; without glass in front or
/// behind.
int worstMix(const osg::Image& picture, double alpha)
{
    const auto &object = Ends::get().finer, &behind = Ends::get().behind;
    double worst = 0.0;
    for (int y = 0; y < picture.t(); ++y)
        for (int x = 0; x < picture.s(); ++x)
            for (int channel = 0; channel < 3; ++channel)
            {
                const double mix =
                    alpha * object->data(x, y)[channel] + (1.0 - alpha) * behind->data(x, y)[channel];
                worst = std::max(worst, std::abs(mix - picture.data(x, y)[channel]));
            }
    return static_cast<int>(std::ceil(worst));
}

TEST(AlphaRange, MixesTheObjectWithWhatIsBehindByEveryMethod)
{
    for (const auto method : {SwitchMethod::discrete, SwitchMethod::alpha, SwitchMethod::continuous,
                              SwitchMethod::blend, SwitchMethod::geomorph})
        for (const double alpha : {0.25, 0.5, 0.9})
        {
            const Picture picture = faded(by(method), alpha);
            EXPECT_LE(worstMix(*picture, alpha), 2) << static_cast<int>(method) << " " << alpha;
            keep(*picture, "fade-" + std::to_string(static_cast<int>(100 * alpha)));
        }
}

TEST(AlphaRange, IsExactAtItsEnds)
{
    EXPECT_TRUE(
        osgOffscreen::compareImages(*faded(by(SwitchMethod::blend), 1.0), *Ends::get().finer).identical());
    EXPECT_TRUE(
        osgOffscreen::compareImages(*faded(by(SwitchMethod::blend), 0.0), *Ends::get().behind).identical());
}

/// Leaves that are cut out by an alpha test do not vanish as a whole when alpha falls below its reference.
TEST(AlphaRange, KeepsWhatAnAlphaTestLeaves)
{
    const osg::ref_ptr<ProgressiveShape> cut = torusOnSheet();
    for (const auto& state : cut->states())
        state->setAttributeAndModes(new osg::AlphaFunc(osg::AlphaFunc::GEQUAL, 0.5F));
    EXPECT_LE(worstMix(*faded(by(SwitchMethod::alpha), 0.25, {}, cut), 0.25), 2);
    // The check can fail: it does not know a test in a state above.
    const auto testAbove = [](Scene& scene)
    {
        scene.node->getOrCreateStateSet()->setAttributeAndModes(
            new osg::AlphaFunc(osg::AlphaFunc::GEQUAL, 0.5F));
    };
    EXPECT_GT(worstMix(*faded(by(SwitchMethod::alpha), 0.25, testAbove), 0.25), 10);
}

/// The comparisons above can fail: without the depth pass an object is blended with its own back side.
TEST(AlphaRangeMutation, WithoutADepthPassItIsSeen)
{
    const auto withoutDepth = [](Scene& scene)
    {
        scene.node->getOrCreateStateSet()->setAttributeAndModes(
            new osg::Depth(osg::Depth::LEQUAL, 0.0, 1.0, false),
            osg::StateAttribute::ON | osg::StateAttribute::OVERRIDE);
    };
    EXPECT_GT(worstMix(*faded(by(SwitchMethod::alpha), 0.5, withoutDepth), 0.5), 10);
}

TEST(AlphaRange, ScalesBlends)
{
    for (const auto profile : {BlendProfile::over, BlendProfile::cross})
    {
        Scene scene(by(SwitchMethod::blend, profile));
        const osg::BoundingSphere ball = scene.node->drawable()->getBound();
        const double away = ball.radius() / std::sin(osg::DegreesToRadians(15.0));
        core::SelectionSettings settings = always(finerSteps());
        settings.alpha = {away - 0.5, away + 0.5};
        ASSERT_TRUE(scene.node->setSelection(settings));
        const auto stage = scene.stage();
        settings.ranges.steps = {coarserSteps()};
        ASSERT_TRUE(scene.node->setSelection(settings));
        int most = 0;
        for (int frame = 0; frame < 32; ++frame)
        {
            const Picture picture = stage->after(kFrameS);
            EXPECT_EQ(outside(*picture, endsAndBehind(), 2), 0) << frame;
            most = std::max(most, strangers(*picture, endsAndBehind()));
        }
        EXPECT_EQ(most > 500, profile == BlendProfile::over) << "a door fades by leaving pixels out";
    }
}

} // namespace
