// SPDX-License-Identifier: Apache-2.0
// The same request gives the same bytes; another request gives others.
#include <osgOffscreen/Backend>

#include "Playing.h"

namespace
{

/// A tour over the hill that has been saved.
class Determinism : public testing::Test
{
protected:
    Playing tour(const std::string& name, const std::vector<std::string>& more = {}) const
    {
        return playedAs(_place, name, {"tour", _place.hill()}, more);
    }

    Playing play(const std::string& name, const std::string& scenario,
                 const std::vector<std::string>& more = {}) const
    {
        return playedAs(_place, name, {"play", _place.path(scenario)}, more);
    }

    /// Not EXPECT_EQ, which would print the pictures.
    static void expectSame(const Playing& a, const Playing& b)
    {
        EXPECT_EQ(a.frames.size(), 4U);
        EXPECT_TRUE(a.frames == b.frames) << "the pictures differ";
        EXPECT_EQ(withoutMeasured(a.statistics), withoutMeasured(b.statistics));
    }

    Workplace _place;
};

TEST_F(Determinism, TwoRunsGiveTheSameBytes)
{
    _place.write("drive.xosc", driveText("hill.tif"));
    expectSame(play("a", "drive.xosc"), play("b", "drive.xosc"));
    expectSame(tour("c", {"--save", _place.path("c.xosc")}), tour("d", {"--save", _place.path("d.xosc")}));
    EXPECT_EQ(readBytes(_place.path("c.xosc")), readBytes(_place.path("d.xosc")));
}

TEST_F(Determinism, APlayOfTheSavedTourIsTheTour)
{
    const Playing flown = tour("flown", {"--save", _place.path("tour.xosc")});
    expectSame(flown, play("played", "tour.xosc"));
}

TEST_F(Determinism, TheNameOfATerrainMakesNoDifference)
{
    const Playing flown = tour("flown");
    // .dem: no suffix that anybody listed; .flt: that of OpenFlight models, too.
    for (const char* name : {"hill.dem", "hill.flt", "hill"})
    {
        std::filesystem::copy_file(_place.hill(), _place.path(name));
        const std::string saved = std::string(name) + ".xosc";
        expectSame(flown, playedAs(_place, saved + "-flown", {"tour", _place.path(name)},
                                   {"--save", _place.path(saved)}));
        expectSame(flown, play(saved + "-played", saved));
    }
}

TEST_F(Determinism, BothBackendsGiveTheSameBytes)
{
    if (!osgOffscreen::isAvailable(osgOffscreen::Backend::osmesa))
        GTEST_SKIP() << "NOT TESTED: this build has no OSMesa";
    for (const std::string samples : {"1", "4"})
        expectSame(tour("osmesa" + samples, {"--backend", "osmesa", "--samples", samples}),
                   tour("egl" + samples, {"--backend", "egl", "--samples", samples}));
    EXPECT_FALSE(bytesIn(_place.path("osmesa1")) == bytesIn(_place.path("osmesa4")))
        << "the samples make no difference";
}

TEST_F(Determinism, MovesFromFrameToFrame)
{
    const Playing flown = tour("flown");
    EXPECT_FALSE(flown.frames.at("frame_00000.png") == flown.frames.at("frame_00003.png"));
}

TEST_F(Determinism, OtherWeatherGivesOtherPictures)
{
    const Playing clear = tour("clear", {"--save", _place.path("clear.xosc")});
    _place.write("fog.xosc",
                 with(readBytes(_place.path("clear.xosc")), "visualRange=\"20000\"", "visualRange=\"900\""));
    const Playing fog = play("fog", "fog.xosc");
    for (const auto& [name, bytes] : clear.frames)
        EXPECT_FALSE(bytes == fog.frames.at(name)) << name << " shows no fog";
    EXPECT_EQ(withoutMeasured(clear.statistics), withoutMeasured(fog.statistics)) << "fog changed the mesh";
}

TEST_F(Determinism, OneRaisedSampleGivesOtherPictures)
{
    tour("as-is", {"--save", _place.path("tour.xosc"), "--frames", "1"});
    _place.writeHill("same.tif", 0.0);
    _place.writeHill("raised.tif", 50.0);
    const Playing original = play("original", "tour.xosc");
    expectSame(original, play("same", "tour.xosc", {"--terrain", _place.path("same.tif")}));
    const Playing raised = play("raised", "tour.xosc", {"--terrain", _place.path("raised.tif")});
    EXPECT_FALSE(original.frames == raised.frames) << "a sample 50 m higher cannot be seen";
}

TEST_F(Determinism, TheChaseCameraIsAnotherEye)
{
    _place.write("drive.xosc", driveText("hill.tif"));
    const Playing own = play("own", "drive.xosc");
    const Playing chase = play("chase", "drive.xosc", {"--eye", "chase"});
    EXPECT_FALSE(own.frames == chase.frames);
    expectSame(chase, play("again", "drive.xosc", {"--eye", "chase"}));
}

} // namespace
