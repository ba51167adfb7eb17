// SPDX-License-Identifier: Apache-2.0
// Settings of the library's nodes and functions: what is given back, what is refused and how the message
// reads.
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <osgPMObjects/BakeModel>
#include <osgPMObjects/MakeProgressive>
#include <osgPMObjects/PmNode>
#include <osgPMObjects/ProgressiveField>
#include <osgPMObjects/ProgressiveNode>
#include <osgPMObjects/ReadModel>

#include "ProgressiveSubject.h"

namespace
{

using namespace osgPMObjects;
using testing::StartsWith;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const double kNotANumber = std::nan("");

const osg::ref_ptr<ProgressiveShape>& shape()
{
    static const osg::ref_ptr<ProgressiveShape> made = progressive::torusAndSheet().shape;
    return made;
}

/// What an outcome says; empty: it succeeded. A message has a place, what is wrong, and a remedy.
std::string said(const foundation::Outcome& outcome)
{
    if (outcome) return "";
    EXPECT_FALSE(outcome.error().what.empty());
    EXPECT_FALSE(outcome.error().remedy.empty());
    return outcome.error().message();
}

/// Matches a message about a field or a part of it.
auto isAt(const std::string& place)
{
    return testing::AnyOf(StartsWith(place + ": "), StartsWith(place + "."));
}

template<class Settings, class Change>
Settings changed(const Change& change)
{
    Settings settings;
    change(settings);
    return settings;
}

TEST(NodeSettings, AreGivenBackAsAWholeAndInParts)
{
    const osg::ref_ptr<ProgressiveNode> node = new ProgressiveNode(shape());
    ProgressiveNodeSettings settings;
    settings.selection.tolerancePx = 2.5;
    settings.switching = {.method = core::SwitchMethod::blend, .durationS = 0.75F};
    settings.priority = {3.0, true};
    settings.number = 12;
    settings.referencePixelsPerTangent = 900.0;
    ASSERT_EQ(said(node->setSettings(settings)), "");
    EXPECT_EQ(node->selection().tolerancePx, 2.5);
    EXPECT_EQ(node->switching(), settings.switching);
    EXPECT_EQ(node->priority().importance, 3.0);
    EXPECT_EQ(node->settings().number, 12u);
    EXPECT_EQ(node->settings().referencePixelsPerTangent, 900.0);

    ASSERT_EQ(said(node->setPriority({4.0, false})), "");
    EXPECT_EQ(node->settings().priority.importance, 4.0);
    EXPECT_EQ(node->settings().number, 12u) << "a part leaves the others as they are";
}

struct RefusedNode
{
    const char* place;
    std::function<void(ProgressiveNodeSettings&)> change;
};

class NodeSettingsRefuse : public testing::TestWithParam<RefusedNode>
{
};

TEST_P(NodeSettingsRefuse, WithThePlaceAndChangeNothing)
{
    const osg::ref_ptr<ProgressiveNode> node = new ProgressiveNode(shape());
    ProgressiveNodeSettings before;
    before.number = 5;
    ASSERT_TRUE(node->setSettings(before));
    const auto wrong = changed<ProgressiveNodeSettings>(GetParam().change);
    EXPECT_THAT(said(node->setSettings(wrong)), isAt(GetParam().place));
    EXPECT_EQ(node->settings().number, 5u);
    EXPECT_FALSE(checkSettings(wrong, 900));
    // Exactly one part is wrong: the setters of the others take theirs.
    const bool isRefusedByOne = !node->setSelection(wrong.selection) + !node->setSwitching(wrong.switching) +
                                    !node->setPriority(wrong.priority) ==
                                1;
    EXPECT_EQ(isRefusedByOne, wrong.referencePixelsPerTangent == 0.0);
}

INSTANTIATE_TEST_SUITE_P(
    Values, NodeSettingsRefuse,
    testing::Values(
        RefusedNode{"ProgressiveNode.selection",
                    [](auto& s) { s.selection.method = core::SelectionMethod::budget; }},
        RefusedNode{"ProgressiveNode.selection", [](auto& s) { s.selection.tolerancePx = kNotANumber; }},
        RefusedNode{"ProgressiveNode.selection", [](auto& s) { s.selection.tolerancePx = kInfinity; }},
        RefusedNode{"ProgressiveNode.selection", [](auto& s) { s.selection.tolerancePx = -1.0; }},
        RefusedNode{"ProgressiveNode.selection", [](auto& s) { s.selection.trianglePx = kInfinity; }},
        RefusedNode{"ProgressiveNode.selection", [](auto& s) { s.selection.referenceM = kInfinity; }},
        RefusedNode{"ProgressiveNode.selection", [](auto& s) { s.selection.band = kInfinity; }},
        RefusedNode{"ProgressiveNode.selection", [](auto& s) { s.selection.continuousBand = 0.5; }},
        RefusedNode{"ProgressiveNode.selection", [](auto& s) { s.selection.weights.normal = std::nanf(""); }},
        RefusedNode{"ProgressiveNode.selection", [](auto& s) { s.selection.weights.colour = -1.0F; }},
        RefusedNode{"ProgressiveNode.selection",
                    [](auto& s) {
                        s.selection.alpha = {kNotANumber, kInfinity};
                    }},
        RefusedNode{"ProgressiveNode.selection",
                    [](auto& s) {
                        s.selection.alpha = {9.0, 8.0};
                    }},
        RefusedNode{"ProgressiveNode.selection",
                    [](auto& s)
                    {
                        s.selection.method = core::SelectionMethod::ranges;
                        s.selection.ranges = {{1.0, kNotANumber, 2.0}, {0, 1, 2, 3}};
                    }},
        RefusedNode{"ProgressiveNode.selection",
                    [](auto& s)
                    {
                        s.selection.method = core::SelectionMethod::sphereArea;
                        s.selection.areaRows = {{kInfinity}, {0, 1}};
                    }},
        RefusedNode{"ProgressiveNode.selection",
                    [](auto& s)
                    {
                        s.selection.method = core::SelectionMethod::ranges;
                        s.selection.ranges = {{1.0}, {0, 99999999}};
                    }},
        RefusedNode{"ProgressiveNode.switching", [](auto& s) { s.switching.durationS = 0.0F; }},
        RefusedNode{"ProgressiveNode.switching", [](auto& s) { s.switching.durationS = std::nanf(""); }},
        RefusedNode{"ProgressiveNode.switching",
                    [](auto& s) { s.switching.staggerS = std::numeric_limits<float>::infinity(); }},
        RefusedNode{"ProgressiveNode.priority.importance", [](auto& s) { s.priority.importance = 0.0; }},
        RefusedNode{"ProgressiveNode.priority.importance",
                    [](auto& s) { s.priority.importance = kNotANumber; }},
        RefusedNode{"ProgressiveNode.priority.importance",
                    [](auto& s) { s.priority.importance = kInfinity; }},
        RefusedNode{"ProgressiveNode.referencePixelsPerTangent",
                    [](auto& s) { s.referencePixelsPerTangent = kInfinity; }},
        RefusedNode{"ProgressiveNode.referencePixelsPerTangent",
                    [](auto& s) { s.referencePixelsPerTangent = -1.0; }}));

template<class Settings>
bool isRefused(const std::string& place, const std::function<void(Settings&)>& change)
{
    EXPECT_EQ(said(checkSettings(Settings{})), "") << "the defaults are good";
    return said(checkSettings(changed<Settings>(change))).starts_with(place + ": ");
}

TEST(BakeModelSettings, ThatAreWrongAreRefused)
{
    using S = BakeModelSettings;
    for (const double slantDeg : {-1.0, 90.0, kNotANumber, kInfinity})
        EXPECT_TRUE(isRefused<S>("BakeModelSettings.charts.mostSlantDeg",
                                 [&](S& s) { s.charts.mostSlantDeg = slantDeg; }));
    for (const int samples : {0, 9})
        EXPECT_TRUE(isRefused<S>("BakeModelSettings.maps.samplesPerSide",
                                 [&](S& s) { s.maps.samplesPerSide = samples; }));
    for (const double reach : {-1.0, kNotANumber, kInfinity})
        EXPECT_TRUE(isRefused<S>("BakeModelSettings.maps.reach", [&](S& s) { s.maps.reach = reach; }));
    BakeModelSettings wrong;
    wrong.maps.reach = kInfinity;
    EXPECT_FALSE(bakeModel({}, {}, wrong));
}

TEST(MakeProgressiveSettings, ThatAreWrongAreRefused)
{
    using S = MakeProgressiveSettings;
    const std::string simplify = "MakeProgressiveSettings.simplify.",
                      arrangement = "MakeProgressiveSettings.arrangement.";
    for (const double wrong : {-1.0, kNotANumber, kInfinity})
    {
        const auto narrow = static_cast<float>(wrong);
        EXPECT_TRUE(isRefused<S>(simplify + "mostTexCoordDrift",
                                 [&](S& s) { s.simplify.mostTexCoordDrift = narrow; }));
        EXPECT_TRUE(isRefused<S>(simplify + "joinDistance", [&](S& s) { s.simplify.joinDistance = wrong; }));
        EXPECT_TRUE(isRefused<S>(simplify + "envelope", [&](S& s) { s.simplify.envelope = wrong; }));
        EXPECT_TRUE(isRefused<S>(arrangement + "tswapStep", [&](S& s) { s.arrangement.tswapStep = narrow; }));
        EXPECT_TRUE(
            isRefused<S>(arrangement + "stayWeight", [&](S& s) { s.arrangement.stayWeight = narrow; }));
        EXPECT_TRUE(isRefused<S>(arrangement + "touchedLineWeight",
                                 [&](S& s) { s.arrangement.touchedLineWeight = narrow; }));
    }
    EXPECT_TRUE(isRefused<S>(arrangement + "cacheSize", [](S& s) { s.arrangement.cacheSize = 2; }));
    EXPECT_TRUE(isRefused<S>("MakeProgressiveSettings.ladder.ratio", [](S& s) { s.ladder->ratio = 1.3; }));
    EXPECT_TRUE(isRefused<S>("MakeProgressiveSettings.ladder.samples", [](S& s) { s.ladder->samples = 1; }));
    EXPECT_TRUE(isRefused<S>(arrangement + "windowBlocks", [](S& s) { s.arrangement.windowBlocks = 1; }));
    MakeProgressiveSettings wrong;
    wrong.simplify.envelope = kInfinity;
    const auto made = makeProgressive(*osg::ref_ptr(new osg::Group), "model", wrong);
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().place, simplify + "envelope");
}

TEST(ReadLimits, ThatAreWrongAreRefused)
{
    for (const double seconds : {0.0, -1.0, kNotANumber, kInfinity})
    {
        EXPECT_TRUE(isRefused<ReadLimits>("ReadLimits.seconds", [&](auto& l) { l.seconds = seconds; }));
        const auto read = readModelNode("model.ac", {.seconds = seconds});
        ASSERT_FALSE(read);
        EXPECT_EQ(read.error().place, "ReadLimits.seconds");
    }
    EXPECT_TRUE(isRefused<ReadLimits>("ReadLimits.memoryMiB", [](auto& l) { l.memoryMiB = 0; }));
}

TEST(PmSettings, WithoutASectionOfStepsAreRefused)
{
    const osg::ref_ptr<ProgressiveNode> node = new ProgressiveNode(shape());
    EXPECT_TRUE(pmNodeBytes(*node));
    core::PmSettings settings;
    settings.stepSections = 0;
    const auto bytes = pmNodeBytes(*node, settings);
    ASSERT_FALSE(bytes);
    EXPECT_EQ(bytes.error().place, "PmSettings.stepSections");
}

TEST(DrawableSteps, AreAtMostThoseOfTheShape)
{
    const osg::ref_ptr<ProgressiveDrawable> drawable = new ProgressiveDrawable(shape());
    const std::uint32_t most = shape()->progressive().stepCount;
    EXPECT_EQ(said(drawable->setSteps(most)), "");
    EXPECT_EQ(drawable->steps(), most);
    EXPECT_THAT(said(drawable->setSteps(most + 1)), StartsWith("ProgressiveDrawable.steps: "));
    EXPECT_EQ(drawable->steps(), most);
    EXPECT_FALSE(osg::ref_ptr<ProgressiveDrawable>(new ProgressiveDrawable)->setSteps(1));
}

TEST(FieldSettings, AreGivenBackAsAWholeAndInParts)
{
    const osg::ref_ptr<ProgressiveField> field = new ProgressiveField;
    ProgressiveFieldSettings settings;
    settings.budget = {.budget = 1234, .band = 1.25};
    settings.attention.gazeInnerDeg = 10.0;
    settings.attention.gazeOuterDeg = 30.0;
    settings.referencePixelsPerTangent = 700.0;
    ASSERT_EQ(said(field->setSettings(settings)), "");
    EXPECT_EQ(field->budget().budget, 1234u);
    EXPECT_EQ(field->attention().gazeOuterDeg, 30.0);
    EXPECT_EQ(field->settings().referencePixelsPerTangent, 700.0);
    ASSERT_EQ(said(field->setBudget({.budget = 99})), "");
    EXPECT_EQ(field->settings().budget.budget, 99u);
    EXPECT_EQ(field->settings().attention.gazeInnerDeg, 10.0);
}

struct RefusedField
{
    const char* place;
    std::function<void(ProgressiveFieldSettings&)> change;
};

class FieldSettingsRefuse : public testing::TestWithParam<RefusedField>
{
};

TEST_P(FieldSettingsRefuse, WithThePlaceAndChangeNothing)
{
    const osg::ref_ptr<ProgressiveField> field = new ProgressiveField;
    ASSERT_TRUE(field->setBudget({.budget = 77}));
    const auto wrong = changed<ProgressiveFieldSettings>(GetParam().change);
    EXPECT_THAT(said(field->setSettings(wrong)), isAt(GetParam().place));
    EXPECT_EQ(field->budget().budget, 77u);
    EXPECT_FALSE(checkSettings(wrong));
    const bool isRefusedByOne = !field->setBudget(wrong.budget) + !field->setAttention(wrong.attention) == 1;
    EXPECT_EQ(isRefusedByOne, wrong.referencePixelsPerTangent == 0.0);
}

INSTANTIATE_TEST_SUITE_P(
    Values, FieldSettingsRefuse,
    testing::Values(
        RefusedField{"ProgressiveField.budget.cost",
                     [](auto& s) { s.budget.cost.perTriangle = kNotANumber; }},
        RefusedField{"ProgressiveField.budget.cost", [](auto& s) { s.budget.cost.perDraw = -1.0; }},
        RefusedField{"ProgressiveField.budget.cost", [](auto& s) { s.budget.cost.perVertex = kInfinity; }},
        RefusedField{"ProgressiveField.budget.band", [](auto& s) { s.budget.band = 0.9; }},
        RefusedField{"ProgressiveField.budget.band", [](auto& s) { s.budget.band = kNotANumber; }},
        RefusedField{"ProgressiveField.attention.attendedGain",
                     [](auto& s) { s.attention.attendedGain = 0.5; }},
        RefusedField{"ProgressiveField.attention.peripheralGain",
                     [](auto& s) { s.attention.peripheralGain = kNotANumber; }},
        RefusedField{"ProgressiveField.attention.gazeInnerDeg",
                     [](auto& s) { s.attention.gazeInnerDeg = -1.0; }},
        RefusedField{"ProgressiveField.attention.gazeOuterDeg",
                     [](auto& s) { s.attention.gazeOuterDeg = 90.0; }},
        RefusedField{"ProgressiveField.attention.gaze",
                     [](auto& s) {
                         s.attention.gaze = {0.0, 0.0, 2.0};
                     }},
        RefusedField{"ProgressiveField.attention.gaze",
                     [](auto& s) {
                         s.attention.gaze = {0.0, kNotANumber, 1.0};
                     }},
        RefusedField{"ProgressiveField.referencePixelsPerTangent",
                     [](auto& s) { s.referencePixelsPerTangent = kNotANumber; }}));

struct RefusedContents
{
    const char* place;
    std::function<void(FieldKind&, FieldInstance&)> change;
};

class FieldContentsRefuse : public testing::TestWithParam<RefusedContents>
{
};

TEST_P(FieldContentsRefuse, WithThePlaceAndChangeNothing)
{
    const osg::ref_ptr<ProgressiveField> field = new ProgressiveField;
    ASSERT_EQ(said(field->setContents({{shape()}}, std::vector<FieldInstance>(3))), "");
    std::vector<FieldKind> kinds(2, FieldKind{shape()});
    std::vector<FieldInstance> instances(4);
    GetParam().change(kinds[1], instances[2]);
    EXPECT_THAT(said(field->setContents(kinds, instances)), isAt(GetParam().place));
    EXPECT_EQ(field->instanceCount(), 3u);
    EXPECT_EQ(field->kinds().size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(
    Values, FieldContentsRefuse,
    testing::Values(
        RefusedContents{"ProgressiveField.kinds[1].shape", [](auto& k, auto&) { k.shape = nullptr; }},
        RefusedContents{"ProgressiveField.kinds[1].selection",
                        [](auto& k, auto&) { k.selection.tolerancePx = kNotANumber; }},
        RefusedContents{"ProgressiveField.kinds[1].switching", [](auto& k, auto&)
                        { k.switching.durationS = std::numeric_limits<float>::infinity(); }},
        RefusedContents{"ProgressiveField.instances[2].kind", [](auto&, auto& i) { i.kind = 2; }},
        RefusedContents{"ProgressiveField.instances[2].position",
                        [](auto&, auto& i) { i.position.y() = kInfinity; }},
        RefusedContents{"ProgressiveField.instances[2].position",
                        [](auto&, auto& i) { i.position.z() = kNotANumber; }},
        RefusedContents{"ProgressiveField.instances[2].attitude",
                        [](auto&, auto& i) { i.attitude.set(0.0, 0.0, 0.0, 2.0); }},
        RefusedContents{"ProgressiveField.instances[2].attitude",
                        [](auto&, auto& i) { i.attitude.set(kNotANumber, 0.0, 0.0, 1.0); }},
        RefusedContents{"ProgressiveField.instances[2].scale", [](auto&, auto& i) { i.scale = 0.0; }},
        RefusedContents{"ProgressiveField.instances[2].scale", [](auto&, auto& i) { i.scale = kInfinity; }},
        RefusedContents{"ProgressiveField.instances[2].priority.importance",
                        [](auto&, auto& i) { i.priority.importance = kInfinity; }}));

} // namespace
