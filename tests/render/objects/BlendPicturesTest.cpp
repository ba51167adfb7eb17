// SPDX-License-Identifier: Apache-2.0
// Blends and screen doors among other objects: no pixel shows anything but the two levels and the background.
#include <osg/Depth>

#include <osgOffscreen/ImageComparison>

#include "SwitchedAmongOthers.h"

namespace
{

using namespace switched;
using core::BlendProfile;
using core::SwitchMethod;

class Blends : public testing::TestWithParam<std::pair<BlendProfile, bool>>
{
protected:
    bool isBack() const { return GetParam().second; }
    std::vector<Picture> pictures(int frames)
    {
        Scene scene(by(SwitchMethod::blend, GetParam().first));
        return picturesOfSwitch(scene, isBack() ? coarserSteps() : finerSteps(),
                                isBack() ? finerSteps() : coarserSteps(), frames);
    }
};

TEST_P(Blends, BeginAndEndInThePicturesOfTheirLevels)
{
    const auto all = pictures(32);
    const Picture &from = isBack() ? Ends::get().coarser : Ends::get().finer,
                  &to = isBack() ? Ends::get().finer : Ends::get().coarser;
    EXPECT_TRUE(osgOffscreen::compareImages(*all.front(), *from).identical());
    EXPECT_TRUE(osgOffscreen::compareImages(*all.back(), *to).identical());
    EXPECT_FALSE(osgOffscreen::compareImages(*all[15], *from).within(100, 8));
    EXPECT_FALSE(osgOffscreen::compareImages(*all[15], *to).within(100, 8));
}

TEST_P(Blends, ShowNothingButTheTwoLevelsAndWhatIsBehind)
{
    const auto all = pictures(32);
    for (std::size_t frame = 0; frame < all.size(); ++frame)
    {
        EXPECT_EQ(outside(*all[frame], endsAndBehind(), 2), 0) << frame;
        EXPECT_EQ(lostRed(*all[frame], *Ends::get().behind), 0) << frame;
        if (frame % 8 == 0)
            keep(*all[frame], std::string(GetParam().first == BlendProfile::over ? "over" : "door") +
                                  (isBack() ? "-back" : "-") + std::to_string(frame));
    }
}

TEST_P(Blends, ChangeThePictureLittleByLittle)
{
    const auto all = pictures(32);
    const double hard = changeBetween(*Ends::get().finer, *Ends::get().coarser).mean;
    for (std::size_t frame = 1; frame < all.size(); ++frame)
        EXPECT_LT(changeBetween(*all[frame - 1], *all[frame]).mean * 4.0, hard) << frame;
}

INSTANTIATE_TEST_SUITE_P(
    Profiles, Blends,
    testing::Values(std::pair{BlendProfile::over, false}, std::pair{BlendProfile::over, true},
                    std::pair{BlendProfile::cross, false}, std::pair{BlendProfile::cross, true}),
    [](const auto& parameter)
    {
        return std::string(parameter.param.first == BlendProfile::over ? "Over" : "Door") +
               (parameter.param.second ? "Back" : "Forth");
    });

/// The depth of both levels hides the background.
TEST(BlendsMutation, WithoutDepthsTheyAreSeen)
{
    Scene scene(by(SwitchMethod::blend));
    scene.node->getOrCreateStateSet()->setAttributeAndModes(
        new osg::Depth(osg::Depth::LEQUAL, 0.0, 1.0, false),
        osg::StateAttribute::ON | osg::StateAttribute::OVERRIDE);
    const auto all = picturesOfSwitch(scene, finerSteps(), coarserSteps(), 16);
    EXPECT_GT(outside(*all[8], endsAndBehind(), 2), 20);
}

TEST(ScreenDoor, ShowsEachPixelOfOneLevelOrTheOther)
{
    Scene scene(by(SwitchMethod::blend, BlendProfile::cross));
    const auto all = picturesOfSwitch(scene, finerSteps(), coarserSteps(), 32);
    for (const Picture& picture : all)
        EXPECT_EQ(strangers(*picture, {Ends::get().finer, Ends::get().coarser}), 0);
    EXPECT_GT(strangers(*all[15], {Ends::get().finer}), 500);
    EXPECT_GT(strangers(*all[15], {Ends::get().coarser}), 500);
    // The check can fail.
    EXPECT_GT(
        strangers(*atRest((finerSteps() + coarserSteps()) / 2), {Ends::get().finer, Ends::get().coarser}),
        500);
}

TEST(ScreenDoor, KeepsItsPatternWhenASwitchRunsBack)
{
    Scene scene(by(SwitchMethod::blend, BlendProfile::cross));
    ASSERT_TRUE(scene.node->setSelection(always(finerSteps())));
    const auto stage = scene.stage();
    ASSERT_TRUE(scene.node->setSelection(always(coarserSteps())));
    Picture before;
    for (int frame = 0; frame < 15; ++frame)
        before = stage->after(kFrameS);
    ASSERT_TRUE(scene.node->setSelection(always(finerSteps())));
    const double hard = changeBetween(*Ends::get().finer, *Ends::get().coarser).mean;
    EXPECT_LT(changeBetween(*before, *stage->after(kFrameS)).mean * 4.0, hard);
    Picture last;
    for (int frame = 0; frame < 20; ++frame)
        last = stage->after(kFrameS);
    EXPECT_TRUE(osgOffscreen::compareImages(*last, *Ends::get().finer).identical());
}

/// Parts that are transparent at rest switch by screen door while the rest of the object is blended, and fade
/// by their own alpha.
TEST(BlendsOfGlass, BeginAndEndInThePicturesOfTheirLevelsAndChangeLittleByLittle)
{
    const osg::ref_ptr<ProgressiveShape> glass = torusOnSheet(true);
    const auto levelAt = [&](std::uint32_t steps)
    {
        Scene scene(by(SwitchMethod::blend), glass);
        EXPECT_TRUE(scene.node->setSelection(always(steps)));
        return scene.stage()->after(kFrameS);
    };
    const Picture from = levelAt(finerSteps()), to = levelAt(coarserSteps());
    EXPECT_GT(changeBetween(*from, *Ends::get().finer).mean, 0.5) << "it is glass";
    Scene scene(by(SwitchMethod::blend), glass);
    const auto all = picturesOfSwitch(scene, finerSteps(), coarserSteps(), 32);
    EXPECT_TRUE(osgOffscreen::compareImages(*all.front(), *from).identical());
    EXPECT_TRUE(osgOffscreen::compareImages(*all.back(), *to).identical());
    const double hard = changeBetween(*from, *to).mean;
    for (std::size_t frame = 1; frame < all.size(); ++frame)
    {
        EXPECT_LT(changeBetween(*all[frame - 1], *all[frame]).mean * 4.0, hard) << frame;
        EXPECT_LE(outside(*all[frame], {from, to, Ends::get().behind}, 8), 20) << frame;
    }
    keep(*all[15], "glass");
}

} // namespace
