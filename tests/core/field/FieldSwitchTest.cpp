// SPDX-License-Identifier: Apache-2.0
#include "core/field/FieldSwitch.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "FieldScenes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::FieldSubject;

constexpr float kStepS = 0.02f;

/// One object in a view whose distance changes.
class Walk
{
public:
    explicit Walk(const SwitchSettings& switching)
    {
        FieldModel model = FieldSubject::torus().model();
        model.switching = switching;
        model.selection.alpha = {600.0, 800.0};
        _field = Field({model}, {FieldObject{}});
        _view.emplace(_field);
    }

    FieldDrawList at(double distance)
    {
        return _view->update(testsupport::cameraFrom(
            testsupport::viewTo({0.0, -distance, 0.0}, {0.0, 0.0, 0.0}), ++_frame, kStepS));
    }

private:
    Field _field;
    std::optional<FieldView> _view;
    std::uint64_t _frame = 0;
};

const FieldBatch* batchOf(const FieldDrawList& drawList, FieldPass pass)
{
    for (const FieldBatch& batch : drawList.batches)
        if (batch.pass == pass) return &batch;
    return nullptr;
}

TEST(FieldSwitch, LeavesNoPixelOfAScreenDoorToNobody)
{
    Walk walk({SwitchMethod::blend, BlendProfile::cross, 0.5f, 0.0f});
    int blends = 0;
    for (double distance = 30.0; distance < 560.0; distance *= 1.01)
    {
        const FieldDrawList drawList = walk.at(distance);
        ASSERT_LE(drawList.instances.size(), 2u);
        if (drawList.instances.size() == 1)
        {
            EXPECT_NE(batchOf(drawList, FieldPass::settled), nullptr);
            continue;
        }
        ++blends;
        const auto &a = drawList.instances[0].transition, &b = drawList.instances[1].transition;
        EXPECT_EQ(std::min(a[0], b[0]), 0.0f);
        EXPECT_EQ(std::max(a[1], b[1]), 1.0f);
        EXPECT_TRUE(a[1] == b[0] || b[1] == a[0]) << "the doors meet";
    }
    EXPECT_GT(blends, 50);
}

TEST(FieldSwitch, HasAlwaysOneOpaqueLevelWhenOneFadesInOverTheOther)
{
    Walk walk({SwitchMethod::blend, BlendProfile::over, 0.5f, 0.0f});
    int blends = 0;
    for (double distance = 30.0; distance < 560.0; distance *= 1.01)
    {
        const FieldDrawList drawList = walk.at(distance);
        ASSERT_NE(batchOf(drawList, FieldPass::settled), nullptr) << distance;
        blends += batchOf(drawList, FieldPass::blended) != nullptr;
    }
    EXPECT_GT(blends, 50);
}

TEST(FieldSwitch, FadesAlongTheAlphaRangeAndIsGoneBeyond)
{
    Walk walk({SwitchMethod::discrete, BlendProfile::over, 0.5f, 0.0f});
    EXPECT_NE(batchOf(walk.at(590.0), FieldPass::settled), nullptr);
    const FieldDrawList half = walk.at(700.0);
    ASSERT_NE(batchOf(half, FieldPass::blended), nullptr);
    EXPECT_NEAR(half.instances.at(0).transition[1], 0.5f, 0.01f);
    const FieldDrawList gone = walk.at(801.0);
    EXPECT_EQ(gone.visible, 1u);
    EXPECT_EQ(gone.drawn, 0u);
    EXPECT_TRUE(gone.instances.empty());
}

/// The position between levels (rung plus morph) never jumps, even if the eye does.
TEST(FieldSwitch, MorphsFromRungToRungWithoutAJump)
{
    Walk walk({SwitchMethod::geomorph, BlendProfile::over, 0.2f, 0.0f});
    double last = -1.0, most = 0.0;
    const LevelLadder& ladder = FieldSubject::torus().ladder;
    for (int i = 0; i < 400; ++i)
    {
        // Quick, but no jump, after which a view settles at once.
        const FieldDrawList drawList =
            walk.at(i < 200 ? 40.0 : std::min(40.0 * std::pow(1.5, i - 199), 300.0));
        ASSERT_EQ(drawList.instances.size(), 1u);
        const std::uint32_t rung = drawList.runs[0].rung;
        const double at = rung + drawList.instances[0].transition[2];
        if (drawList.instances[0].transition[2] > 0.0f)
        {
            EXPECT_EQ(drawList.instances[0].transition[3], static_cast<float>(ladder.rungs[rung + 1].wedges));
        }
        if (last >= 0.0) most = std::max(most, std::abs(at - last));
        last = at;
    }
    EXPECT_GT(last, 3.0) << "it has gone several rungs";
    // The largest change in a step: a tenth of the rungs between.
    EXPECT_LT(most, 0.1 * static_cast<double>(ladder.rungs.size()));
    EXPECT_GT(most, 0.0);
}

TEST(FieldSwitch, ComesToRestOnTheRungThatIsWanted)
{
    testsupport::Random random(11);
    for (const auto method : {SwitchMethod::discrete, SwitchMethod::blend, SwitchMethod::geomorph})
    {
        SwitchState state;
        const SwitchSettings settings{method, BlendProfile::cross, 0.3f, 0.1f};
        for (int round = 0; round < 300; ++round)
        {
            const auto wanted = static_cast<std::uint32_t>(random.unit() * 12);
            DrawnLevels drawn;
            const int steps = round % 3 == 0 ? 400 : 7;
            for (int i = 0; i < steps; ++i)
            {
                drawn = advanceOnLadder(state, wanted, kStepS, 1.0f, 5, settings);
                ASSERT_TRUE(isSwitchState(state));
                if (method == SwitchMethod::geomorph && drawn.morph > 0.0f)
                {
                    ASSERT_EQ(drawn.coarser, drawn.first.level + 1) << "vertices have one target each";
                }
            }
            if (steps > 100)
            {
                EXPECT_EQ(drawn.first.level, wanted);
            }
        }
    }
}

} // namespace
