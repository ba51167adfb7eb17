// SPDX-License-Identifier: Apache-2.0
// What `--sound` writes beside offscreen pictures.
#include <algorithm>
#include <fstream>
#include <iterator>

#include "Playing.h"

namespace
{

class SeatSound : public testing::Test
{
protected:
    ProgramRun fly(const std::string& file, const std::vector<std::string>& more = {})
    {
        const std::string aircraft = OSGTRAINER_SOURCE_DIR "/data/aircraft/c172p.xml";
        std::vector<std::string> words{"fly",           place.hill(), "--aircraft", aircraft, "--start",
                                       "0,0,300,90,50", "--frames",   "10",         "--fps",  "7",
                                       "--size",        "64x36",      "--sound",    file};
        words.insert(words.end(), more.begin(), more.end());
        return runTrainer(words);
    }

    static std::string allOf(const std::string& file)
    {
        std::ifstream stream(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    }

    Workplace place;
};

TEST_F(SeatSound, IsAsLongAsThePlayAndTheSameTwice)
{
    ASSERT_TRUE(succeeds(fly(place.path("a.wav"))));
    ASSERT_TRUE(succeeds(fly(place.path("b.wav"))));
    const std::string first = allOf(place.path("a.wav"));
    EXPECT_EQ(first.size(), 44U + 4U * 63'000U); // 10 pictures at 7 a second
    EXPECT_TRUE(first == allOf(place.path("b.wav")));
    EXPECT_TRUE(std::any_of(first.begin() + 44, first.end(), [](char c) { return c != 0; }));
    // The control: another flight sounds of its own.
    ASSERT_TRUE(succeeds(fly(place.path("c.wav"), {"--wind", "90,30"})));
    EXPECT_FALSE(first == allOf(place.path("c.wav")));
}

TEST_F(SeatSound, IsSilentWhenMuted)
{
    ASSERT_TRUE(succeeds(fly(place.path("mute.wav"), {"--mute"})));
    const std::string silent = allOf(place.path("mute.wav"));
    EXPECT_EQ(silent.size(), 44U + 4U * 63'000U);
    EXPECT_TRUE(std::all_of(silent.begin() + 44, silent.end(), [](char c) { return c == 0; }));
}

TEST_F(SeatSound, SaysWhatIsWrong)
{
    EXPECT_TRUE(failsWith(fly(place.path("nowhere/a.wav")), 1, "trainer", {"nowhere", "cannot be created"}));
    std::filesystem::create_symlink("/dev/full", place.path("full.wav"));
    EXPECT_TRUE(failsWith(fly(place.path("full.wav")), 1, "trainer", {"full.wav", "cannot be written"}));
    EXPECT_TRUE(failsWith(fly(place.path("a.mp3")), 2, "trainer", {"a.mp3", ".wav"}));
    EXPECT_TRUE(failsWith(fly(place.path("a.wav"), {"--window"}), 2, "trainer", {"--sound", "window"}));
}

} // namespace
