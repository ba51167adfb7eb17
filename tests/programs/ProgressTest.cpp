// SPDX-License-Identifier: Apache-2.0
#include "terminal/Progress.h"

#include <gtest/gtest.h>

namespace
{

using terminal::ProgressText;

TEST(Progress, TellsWhatIsDoneAndHowLongTheRestTakes)
{
    EXPECT_EQ((ProgressText{"frames", "", 60, 240, 4.0}).text(), "frames: 60/240, 4 s, about 12 s left");
    EXPECT_EQ((ProgressText{"worldtool", "streets", 40, 100, 20.0}).text(),
              "worldtool: streets, 40 % done, 20 s, about 30 s left");
}

TEST(Progress, TellsNoRestThatItCannotKnow)
{
    EXPECT_EQ((ProgressText{"frames", "", 60, 0, 4.0}).text(), "frames: 60, 4 s");
    EXPECT_EQ((ProgressText{"frames", "", 0, 240, 4.0}).text(), "frames: 0/240, 4 s");
    EXPECT_EQ((ProgressText{"frames", "", 240, 240, 4.0}).text(), "frames: 240/240, 4 s");
    EXPECT_EQ((ProgressText{"worldtool", "elevation", 0, 100, 3.0}).text(),
              "worldtool: elevation, 0 % done, 3 s");
    EXPECT_EQ((ProgressText{"model.pm", "", 0, 0, 3.0}).text(), "model.pm, 3 s");
}

TEST(Progress, IsQuietWhereAllIsDoneInTwoSeconds)
{
    testing::internal::CaptureStderr();
    {
        terminal::Progress progress("frames", 10);
        for (int i = 0; i < 10; ++i)
            progress.advance();
        progress.begin("the end", 1);
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

} // namespace
