// SPDX-License-Identifier: Apache-2.0
// Several channels: one folder of pictures for each, or one picture of all.
#include "Playing.h"

namespace
{

const std::string kChannels =
    "<Channel name=\"left\" widthPx=\"64\" heightPx=\"48\" yawDeg=\"-40\" fovXDeg=\"40\"/>\n"
    "<Channel name=\"right\" widthPx=\"80\" heightPx=\"48\" yawDeg=\"0\" fovXDeg=\"40\"/>\n";

/// Two frames of a tour, seen through a view file.
Playing seenThrough(const Workplace& place, const std::string& name, const std::string& view)
{
    const std::string file = place.write(name + ".xml", view);
    return playedAs(place, name, {"tour", place.hill()}, {"--view", file, "--frames", "2"});
}

TEST(Channels, EachHasAFolderOfItsOwn)
{
    const Workplace place;
    const Playing playing = seenThrough(place, "wide", "<View>\n" + kChannels + "</View>\n");
    std::vector<std::string> names;
    for (const auto& [name, bytes] : playing.frames)
        names.push_back(name);
    EXPECT_EQ(names, (std::vector<std::string>{"left/frame_00000.png", "left/frame_00001.png",
                                               "right/frame_00000.png", "right/frame_00001.png"}));
    EXPECT_EQ(factsOf(place.path("wide/left/frame_00001.png")).widthPx, 64);
    EXPECT_EQ(factsOf(place.path("wide/right/frame_00001.png")).widthPx, 80);
    EXPECT_EQ(playing.statistics.at("frames").size(), 2U);
}

TEST(Channels, TiledOnesShareOnePicture)
{
    const Workplace place;
    const Playing playing =
        seenThrough(place, "tiled", "<View layout=\"tiled\">\n" + kChannels + "</View>\n");
    EXPECT_EQ(playing.frames.size(), 2U);
    const PictureFacts facts = factsOf(place.path("tiled/frame_00001.png"));
    EXPECT_EQ(facts.widthPx, 144);
    EXPECT_EQ(facts.heightPx, 48);
    EXPECT_GT(facts.colours, 100U);
}

TEST(Channels, LookWhereTheirFileSays)
{
    const Workplace place;
    const std::string view = "<View>\n" + kChannels + "</View>\n";
    const Playing a = seenThrough(place, "a", view);
    const Playing b = seenThrough(place, "b", view);
    const Playing turned = seenThrough(place, "c", with(view, "yawDeg=\"-40\"", "yawDeg=\"-20\""));
    EXPECT_TRUE(a.frames == b.frames) << "two runs differ";
    EXPECT_FALSE(a.frames.at("left/frame_00000.png") == turned.frames.at("left/frame_00000.png"));
    EXPECT_TRUE(a.frames.at("right/frame_00000.png") == turned.frames.at("right/frame_00000.png"))
        << "one channel's direction changed the other";
}

} // namespace
