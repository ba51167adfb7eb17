// SPDX-License-Identifier: Apache-2.0
// The same request gives the same bytes; another request gives others.
#include "Playing.h"

namespace
{

/// A tour over the hill that has been saved.
class Determinism : public testing::Test
{
protected:
    Playing tour(const std::string& name, const std::vector<std::string>& more = {}) const
    {
        return playedAs(place, name, {"tour", place.hill()}, more);
    }

    Playing play(const std::string& name, const std::string& scenario,
                 const std::vector<std::string>& more = {}) const
    {
        return playedAs(place, name, {"play", place.path(scenario)}, more);
    }

    /// Not EXPECT_EQ, which would print the pictures.
    static void expectSame(const Playing& a, const Playing& b)
    {
        EXPECT_EQ(a.frames.size(), 4U);
        EXPECT_TRUE(a.frames == b.frames) << "the pictures differ";
        EXPECT_EQ(withoutMeasured(a.statistics), withoutMeasured(b.statistics));
    }

    Workplace place;
};

TEST_F(Determinism, TwoRunsGiveTheSameBytes)
{
    place.write("drive.xosc", driveText("hill.tif"));
    expectSame(play("a", "drive.xosc"), play("b", "drive.xosc"));
    expectSame(tour("c", {"--save", place.path("c.xosc")}), tour("d", {"--save", place.path("d.xosc")}));
    EXPECT_EQ(readBytes(place.path("c.xosc")), readBytes(place.path("d.xosc")));
}

TEST_F(Determinism, APlayOfTheSavedTourIsTheTour)
{
    const Playing flown = tour("flown", {"--save", place.path("tour.xosc")});
    expectSame(flown, play("played", "tour.xosc"));
}

TEST_F(Determinism, BothBackendsGiveTheSameBytes)
{
    for (const std::string samples : {"1", "4"})
        expectSame(tour("osmesa" + samples, {"--backend", "osmesa", "--samples", samples}),
                   tour("egl" + samples, {"--backend", "egl", "--samples", samples}));
    EXPECT_FALSE(bytesIn(place.path("osmesa1")) == bytesIn(place.path("osmesa4")))
        << "the samples make no difference";
}

TEST_F(Determinism, MovesFromFrameToFrame)
{
    const Playing flown = tour("flown");
    EXPECT_FALSE(flown.frames.at("frame_00000.png") == flown.frames.at("frame_00003.png"));
}

TEST_F(Determinism, OtherWeatherGivesOtherPictures)
{
    const Playing clear = tour("clear", {"--save", place.path("clear.xosc")});
    place.write("fog.xosc",
                with(readBytes(place.path("clear.xosc")), "visualRange=\"20000\"", "visualRange=\"900\""));
    const Playing fog = play("fog", "fog.xosc");
    for (const auto& [name, bytes] : clear.frames)
        EXPECT_FALSE(bytes == fog.frames.at(name)) << name << " shows no fog";
    EXPECT_EQ(withoutMeasured(clear.statistics), withoutMeasured(fog.statistics)) << "fog changed the mesh";
}

TEST_F(Determinism, OneRaisedSampleGivesOtherPictures)
{
    tour("as-is", {"--save", place.path("tour.xosc"), "--frames", "1"});
    place.writeHill("same.tif", 0.0);
    place.writeHill("raised.tif", 50.0);
    const Playing original = play("original", "tour.xosc");
    expectSame(original, play("same", "tour.xosc", {"--terrain", place.path("same.tif")}));
    const Playing raised = play("raised", "tour.xosc", {"--terrain", place.path("raised.tif")});
    EXPECT_FALSE(original.frames == raised.frames) << "a sample 50 m higher cannot be seen";
}

TEST_F(Determinism, TheChaseCameraIsAnotherEye)
{
    place.write("drive.xosc", driveText("hill.tif"));
    const Playing own = play("own", "drive.xosc");
    const Playing chase = play("chase", "drive.xosc", {"--eye", "chase"});
    EXPECT_FALSE(own.frames == chase.frames);
    expectSame(chase, play("again", "drive.xosc", {"--eye", "chase"}));
}

} // namespace
