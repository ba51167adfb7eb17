// SPDX-License-Identifier: Apache-2.0
// Geomorphs, drawn: they begin and end in the images of their levels and change gradually.
#include <array>
#include <cmath>
#include <set>

#include <osgOffscreen/ImageComparison>
#include <osgPMObjects/ObjectShader>

#include "RealData.h"
#include "RealProgressive.h"
#include "SwitchedScene.h"

namespace
{

using namespace switched;

/// The object with a light at the eye, below a state with the program that draws switching objects, so that
/// one at rest has the same light.
struct Lit
{
    osg::ref_ptr<ProgressiveNode> node;
    osg::ref_ptr<osg::Group> scene = new osg::Group;

    explicit Lit(const osg::ref_ptr<ProgressiveShape>& shape, const core::SwitchSettings& switching,
                 osg::StateSet* program = nullptr)
        : node(new ProgressiveNode(shape))
    {
        EXPECT_TRUE(node->setSwitching(switching));
        if (program)
            scene->setStateSet(program);
        else
            addObjectShading(*scene->getOrCreateStateSet());
        scene->addChild(node);
    }
    osg::BoundingSphere ball() const { return node->drawable()->getBound(); }
};

std::vector<Picture> picturesOfSwitch(Lit& lit, std::uint32_t from, std::uint32_t to, int samples, int frames)
{
    const auto stage = Stage::of(*lit.scene, samples);
    stage->lookAt(lit.ball(), 1.3);
    EXPECT_TRUE(lit.node->setSelection(always(from)));
    stage->after(kFrameS); // skips differences of a context's first frame
    std::vector<Picture> pictures;
    pictures.push_back(stage->after(kFrameS));
    EXPECT_TRUE(lit.node->setSelection(always(to)));
    for (int frame = 0; frame < frames; ++frame)
        pictures.push_back(stage->after(kFrameS));
    return pictures;
}

Change largestChange(const std::vector<Picture>& pictures)
{
    Change largest;
    for (std::size_t i = 1; i < pictures.size(); ++i)
        largest = worst(largest, changeBetween(*pictures[i - 1], *pictures[i]));
    return largest;
}

/// Returns how many times less a morph changes the image from frame to frame than a switch at once, in either
/// direction.
struct Gain
{
    double mean = 1e9, largest = 1e9;
};

Gain gainOfMorph(const osg::ref_ptr<ProgressiveShape>& shape, std::uint32_t a, std::uint32_t b,
                 const std::string& name, osg::StateSet* program = nullptr)
{
    constexpr int kSamples = 4, kFrames = 33;
    Gain gain;
    for (const bool isBack : {false, true})
    {
        const std::uint32_t from = isBack ? b : a, to = isBack ? a : b;
        Lit hard(shape, by(core::SwitchMethod::discrete), program),
            morph(shape, by(core::SwitchMethod::geomorph), program);
        const Change hardly = largestChange(picturesOfSwitch(hard, from, to, kSamples, 2));
        const auto pictures = picturesOfSwitch(morph, from, to, kSamples, kFrames);
        const Change softly = largestChange(pictures);
        EXPECT_GT(hardly.mean, 0.0);
        printf("%s %u to %u: mean %.3f hard, %.3f morph (%.1f x); largest %d, %d (%.1f x)\n", name.c_str(),
               from, to, hardly.mean, softly.mean, hardly.mean / softly.mean, hardly.largest, softly.largest,
               static_cast<double>(hardly.largest) / softly.largest);
        gain.mean = std::min(gain.mean, hardly.mean / softly.mean);
        gain.largest = std::min(gain.largest, static_cast<double>(hardly.largest) / softly.largest);
        for (std::size_t i = 0; i < pictures.size(); i += 8)
            keep(*pictures[i], name + (isBack ? "-back" : "-") + std::to_string(i));
    }
    return gain;
}

TEST(Geomorph, BeginsAndEndsInThePicturesOfItsLevels)
{
    const std::uint32_t most = made()->progressive().stepCount;
    for (const auto& [from, to] : {std::pair{most / 3, most * 3 / 4}, std::pair{most * 3 / 4, most / 3}})
    {
        Lit hard(made(), by(core::SwitchMethod::discrete)), morph(made(), by(core::SwitchMethod::geomorph));
        const auto levels = picturesOfSwitch(hard, from, to, 1, 1);
        const auto pictures = picturesOfSwitch(morph, from, to, 1, 33);
        // Half a second is thirty frames; the first shows the level from which the morph begins.
        EXPECT_TRUE(osgOffscreen::compareImages(*pictures[0], *levels[0]).identical());
        EXPECT_TRUE(osgOffscreen::compareImages(*pictures[1], *levels[0]).within(16, 1))
            << osgOffscreen::compareImages(*pictures[1], *levels[0]).message();
        EXPECT_FALSE(osgOffscreen::compareImages(*pictures[15], *levels[0]).within(16, 1));
        EXPECT_FALSE(osgOffscreen::compareImages(*pictures[15], *levels[1]).within(16, 1));
        EXPECT_TRUE(osgOffscreen::compareImages(*pictures.back(), *levels[1]).identical());
    }
}

TEST(Geomorph, ChangesThePictureAtLeastFourTimesLessThanAHardSwitch)
{
    const std::uint32_t most = made()->progressive().stepCount;
    const Gain gain = gainOfMorph(made(), most / 2, most * 9 / 10, "made");
    EXPECT_GE(gain.mean, 4.0);
}

/// Returns how much levels change the image while an eye approaches: the same eye before and after a change
/// of level.
Change largestChangeOfApproach(const osg::ref_ptr<ProgressiveShape>& shape, core::SwitchMethod method)
{
    constexpr int kSamples = 2, kFrames = 150;
    constexpr std::array kShares = {1.6, 1.1, 0.75, 0.5}; // of the image's height, where levels change
    Lit lit(shape, by(method));
    const double whole = lit.ball().radius() / std::sin(osg::DegreesToRadians(15.0));
    const std::uint32_t most = shape->progressive().stepCount;
    core::SelectionSettings coming = always(0);
    coming.ranges.steps = {most * 6 / 10, most * 75 / 100, most * 85 / 100, most * 92 / 100, most * 97 / 100};
    for (const double share : kShares)
        coming.ranges.boundariesM.push_back(whole / share);
    EXPECT_TRUE(lit.node->setSelection(coming));
    const auto stage = Stage::of(*lit.scene, kSamples, 160, 120);
    Change largest;
    std::set<std::uint32_t> levels;
    for (int frame = 0; frame < kFrames; ++frame)
    {
        stage->lookAt(lit.ball(), 0.4 * std::pow(5.0, frame / (kFrames - 1.0)));
        if (frame < 2)
        {
            stage->after(kFrameS);
            continue;
        }
        const std::uint32_t aim = lit.node->statistics().at(0).switching.to;
        levels.insert(aim);
        EXPECT_TRUE(lit.node->setSelection(always(aim)));
        const Picture before = stage->after(0.0);
        EXPECT_TRUE(lit.node->setSelection(coming));
        largest = worst(largest, changeBetween(*before, *stage->after(kFrameS)));
    }
    EXPECT_EQ(levels.size(), kShares.size() + 1);
    return largest;
}

double gainOfApproach(const osg::ref_ptr<ProgressiveShape>& shape, const std::string& name)
{
    const Change hard = largestChangeOfApproach(shape, core::SwitchMethod::discrete),
                 morph = largestChangeOfApproach(shape, core::SwitchMethod::geomorph);
    printf("%s, an approach: mean %.3f hard, %.3f morph (%.1f x); largest %d, %d (%.1f x)\n", name.c_str(),
           hard.mean, morph.mean, hard.mean / morph.mean, hard.largest, morph.largest,
           static_cast<double>(hard.largest) / morph.largest);
    return hard.mean / morph.mean;
}

TEST(Geomorph, ChangesThePictureAtLeastFourTimesLessAllAlongAnApproach)
{
    EXPECT_GE(gainOfApproach(made(), "made"), 4.0);
}

/// The comparison above can fail: below a program that does not call the functions of the morph, the switch
/// is at once.
TEST(GeomorphMutation, VerticesThatDoNotMoveAreSeen)
{
    const osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    const osg::ref_ptr<osg::Program> program = new osg::Program;
    program->addShader(new osg::Shader(osg::Shader::VERTEX,
                                       "#version 130\nout vec3 normal; void main() { normal = "
                                       "gl_NormalMatrix * gl_Normal; gl_Position = ftransform(); }"));
    program->addShader(new osg::Shader(
        osg::Shader::FRAGMENT,
        "#version 130\nin vec3 normal; void main() { gl_FragColor = vec4(normalize(normal).zzz, 1.0); }"));
    state->setAttributeAndModes(program);
    const std::uint32_t most = made()->progressive().stepCount;
    EXPECT_LT(gainOfMorph(made(), most / 2, most * 9 / 10, "unmoved", state).mean, 2.0);
}

class GeomorphOfModels : public testing::TestWithParam<const char*>
{
};

TEST_P(GeomorphOfModels, ChangesThePictureAtLeastFourTimesLessThanAHardSwitch)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, std::string("models/") + GetParam());
    const auto real = progressive::RealProgressive::of(file);
    ASSERT_TRUE(real);
    const osg::ref_ptr<ProgressiveShape> shape = const_cast<ProgressiveShape*>(&real->shape());
    const std::uint32_t most = shape->progressive().stepCount;
    const Gain gain =
        gainOfMorph(shape, most * 8 / 10, most * 95 / 100, std::filesystem::path(GetParam()).stem().string());
    EXPECT_GE(gain.mean, 4.0);
    EXPECT_GE(gainOfApproach(shape, std::filesystem::path(GetParam()).stem().string()), 4.0);
}

INSTANTIATE_TEST_SUITE_P(Real, GeomorphOfModels,
                         testing::Values("aircraft/cessna.obj", "cad/standingblob.obj"),
                         testsupport::AfterFile());

} // namespace
