// SPDX-License-Identifier: Apache-2.0
// Distant levels are made in one pass, and no frame applies more steps than take as long.
#include <gtest/gtest.h>

#include <osgPMObjects/ProgressiveDrawable>

#include "HandCull.h"
#include "ProgressiveSubject.h"
#include "progressive/ShapeJumps.h"

namespace
{

using namespace progressive;
using handcull::cameraAt;
using handcull::cull;

/// A mesh of 8 520 positions with two materials.
const Subject& jumpSubject()
{
    static const Subject made = subjectOf(
        testsupport::together(testsupport::torus(90, 60), testsupport::waves(60, 50), {4.0, 0.0, 0.0}));
    return made;
}

std::uint32_t most()
{
    return jumpSubject().shape->progressive().stepCount;
}

/// Culls frames of one drawable and counts the steps of each.
class Frames
{
public:
    Frames() : _drawable(new ProgressiveDrawable(jumpSubject().shape)) {}

    /// Culls the next frame and returns what it shows.
    std::vector<SeenTriangle> next(std::uint32_t steps)
    {
        EXPECT_TRUE(_drawable->setSteps(steps));
        const auto drawn = trianglesOf(cull(*_drawable, *_camera, ++_frame).drawables);
        const std::uint64_t before = _statistics.played.steps;
        _statistics = _drawable->statistics().at(0);
        _played = _statistics.played.steps - before;
        EXPECT_EQ(_statistics.steps, steps);
        EXPECT_EQ(_statistics.triangles, drawn.size());
        return drawn;
    }
    std::uint64_t played() const { return _played; }
    std::uint32_t jumps() const { return _statistics.jumps; }

private:
    osg::ref_ptr<ProgressiveDrawable> _drawable;
    osg::ref_ptr<osg::Camera> _camera = cameraAt({8.0, -60.0, 3.0}, {8.0, 0.0, 0.0});
    unsigned _frame = 0;
    ProgressiveViewStatistics _statistics;
    std::uint64_t _played = 0;
};

std::vector<SeenTriangle> expectedAfter(std::uint32_t steps)
{
    return trianglesOf(core::meshAfter(jumpSubject().mesh, jumpSubject().sequence, steps));
}

} // namespace

TEST(Jump, IsToTheVeryLevelAndNoFramePlaysMoreThanAFewSteps)
{
    const std::uint32_t few = ShapeJumps::shortest(jumpSubject().shape->progressive());
    ASSERT_GT(most(), 6 * few);
    Frames frames;
    for (const std::uint32_t steps : {0u, most() - 100, 50u, most() / 2})
    {
        const auto expected = expectedAfter(steps);
        const std::uint32_t jumps = frames.jumps();
        for (std::uint32_t frame = 0; frame <= most() / few + 1; ++frame)
        {
            ASSERT_EQ(frames.next(steps), expected) << steps << ", frame " << frame;
            EXPECT_LE(frames.played(), 2 * few);
        }
        EXPECT_EQ(frames.jumps(), jumps + 1);
        EXPECT_EQ(frames.played(), 0u) << "the steps have been made up for";
    }
}

TEST(Jump, IsMadeUpForWhileTheLevelMovesOn)
{
    const std::uint32_t few = ShapeJumps::shortest(jumpSubject().shape->progressive());
    Frames frames;
    std::uint32_t jumpsBefore = 0;
    for (std::uint32_t steps = 0; steps < 600; steps += 30)
    {
        jumpsBefore = frames.jumps();
        EXPECT_EQ(frames.next(steps), expectedAfter(steps)) << steps;
        EXPECT_LE(frames.played(), 2 * few);
    }
    EXPECT_GT(jumpsBefore, 2u) << "as long as the level is far";
    EXPECT_EQ(frames.jumps(), jumpsBefore) << "not any more";
}

TEST(Jump, IsNotMadeToALevelNearBy)
{
    Frames frames;
    frames.next(most());
    for (std::uint32_t steps = most(); steps > most() / 2; steps -= 300)
        frames.next(steps);
    EXPECT_EQ(frames.jumps(), 0u);
    EXPECT_EQ(torusAndSheet().shape->jumps(), nullptr) << "has hardly more steps than a jump costs";
}
