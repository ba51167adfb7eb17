// SPDX-License-Identifier: Apache-2.0
// The depth pass of a blend, which is drawn before its colours: images without it are worse.
#include <osg/ColorMask>
#include <osg/Depth>
#include <osgUtil/RenderBin>

#include <osgPMObjects/ProgressiveField>

#include "SwitchedAmongOthers.h"
#include "field/FieldStates.h"

namespace
{

using namespace switched;
using core::SwitchMethod;

/// Returns whether a drawable writes depth alone.
bool isDepthOnly(const osgUtil::RenderLeaf& leaf)
{
    for (const osgUtil::StateGraph* at = leaf._parent; at; at = at->_parent)
    {
        const osg::StateSet* const state = at->getStateSet();
        const auto* const mask =
            state ? dynamic_cast<const osg::ColorMask*>(state->getAttribute(osg::StateAttribute::COLORMASK))
                  : nullptr;
        if (mask) return !mask->getRedMask() && !mask->getGreenMask() && !mask->getBlueMask();
    }
    return false;
}

/// While it lives, bins that OSG sorts by depth draw in another order, without drawables that isDepthOnly().
class WithoutDepthPass
{
public:
    WithoutDepthPass() : _prototype(osgUtil::RenderBin::getRenderBinPrototype("DepthSortedBin"))
    {
        _prototype->setSortCallback(new Sort(_left));
    }
    ~WithoutDepthPass() { _prototype->setSortCallback(nullptr); }
    WithoutDepthPass(const WithoutDepthPass&) = delete;
    WithoutDepthPass& operator=(const WithoutDepthPass&) = delete;

    std::size_t left() const { return _left; } ///< drawables left out

private:
    struct Sort : osgUtil::RenderBin::SortCallback
    {
        explicit Sort(std::size_t& leftOut) : left(leftOut) {}
        void sortImplementation(osgUtil::RenderBin* bin) override
        {
            bin->sortBackToFront();
            left += std::erase_if(bin->getRenderLeafList(),
                                  [](const osgUtil::RenderLeaf* leaf) { return isDepthOnly(*leaf); });
        }
        std::size_t& left;
    };

    std::size_t _left = 0;
    osg::ref_ptr<osgUtil::RenderBin> _prototype;
};

std::vector<Picture> picturesOfBlend()
{
    Scene scene(by(SwitchMethod::blend));
    return picturesOfSwitch(scene, finerSteps(), coarserSteps(), 31);
}

/// A torus seen from above, in front of the sheet that belongs to the same object.
Picture fromAbove(osg::Node& scene)
{
    const auto stage = Stage::of(scene);
    stage->lookAt(osg::BoundingSphere(osg::Vec3(), 4.5F), 1.0, {0.1, -0.4, 1.0});
    return stage->after(kFrameS);
}

core::SelectionSettings finest(bool isFading)
{
    core::SelectionSettings settings = always(0);
    if (isFading) settings.alpha = {0.0, 40.0};
    return settings;
}

Picture pictureOfObject(bool isFading)
{
    const osg::ref_ptr<ProgressiveNode> node = new ProgressiveNode(made());
    EXPECT_TRUE(node->setSwitching(by(SwitchMethod::blend)));
    EXPECT_TRUE(node->setSelection(finest(isFading)));
    return fromAbove(*node);
}

/// Two objects, one of them half in front of the other.
Picture pictureOfField(bool isFading)
{
    const FieldKind kind{made(), finest(isFading), by(SwitchMethod::blend)};
    std::vector<FieldInstance> two(2);
    two[1].position = {-16.0, 1.0, 3.0};
    const osg::ref_ptr<ProgressiveField> field = new ProgressiveField;
    EXPECT_TRUE(field->setContents({kind}, two));
    return fromAbove(*field);
}

TEST(BlendDepths, KeepLevelsFromBeingMixedWithThemselves)
{
    const auto all = picturesOfBlend();
    for (std::size_t frame = 0; frame < all.size(); ++frame)
        EXPECT_EQ(outside(*all[frame], endsAndBehind(), 2), 0) << frame;

    // The mutation: without the depth pass.
    const WithoutDepthPass without;
    const auto wrong = picturesOfBlend();
    EXPECT_GE(without.left(), 2u * 28u) << "two materials";
    EXPECT_GT(outside(*wrong[20], endsAndBehind(), 2), 50);
}

TEST(BlendDepths, LetNothingOfAFadingObjectShineThroughIt)
{
    const Picture solid = pictureOfObject(false), faded = pictureOfObject(true);
    const std::vector<Picture> ends{solid, fromAbove(*new osg::Group)};
    EXPECT_EQ(outside(*faded, ends, 2), 0);
    EXPECT_GT(changeBetween(*faded, *solid).mean, 3.0) << "it is faded";
    EXPECT_GT(changeBetween(*faded, *ends[1]).mean, 3.0) << "it is there";
    keep(*faded, "fade-with-depths");

    // The mutation: without the depth pass.
    const WithoutDepthPass without;
    const Picture wrong = pictureOfObject(true);
    EXPECT_EQ(without.left(), 2u);
    EXPECT_GT(outside(*wrong, ends, 2), 1000);
    keep(*wrong, "fade-without-depths");
}

TEST(BlendDepths, LetNothingOfAFadingFieldShineThroughIt)
{
    const Picture solid = pictureOfField(false), faded = pictureOfField(true);
    const std::vector<Picture> ends{solid, fromAbove(*new osg::Group)};
    EXPECT_EQ(outside(*faded, ends, 2), 0);
    EXPECT_GT(changeBetween(*faded, *solid).mean, 3.0) << "it is faded";
    EXPECT_GT(changeBetween(*faded, *ends[1]).mean, 3.0) << "it is there";
    keep(*faded, "field-with-depths");

    // The mutation: the depth pass writes no depth.
    osg::StateSet& pass = *FieldStates::shared().blendedDepth;
    pass.setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0.0, 1.0, false),
                              osg::StateAttribute::ON | osg::StateAttribute::OVERRIDE);
    const Picture wrong = pictureOfField(true);
    pass.removeAttribute(osg::StateAttribute::DEPTH);
    EXPECT_GT(outside(*wrong, ends, 2), 1000);
    keep(*wrong, "field-without-depths");
    EXPECT_EQ(outside(*pictureOfField(true), ends, 2), 0) << "as before";
}

} // namespace
