// SPDX-License-Identifier: Apache-2.0
// The same request gives the same bytes; another request gives others.
#include <memory>

#include <osgOffscreen/Backend>

#include "Playing.h"

namespace
{

/// Requests of a tour over the hill and of a drive. What the first run of each gave is shared by the tests.
class Determinism : public testing::Test
{
protected:
    struct First
    {
        Workplace place;
        Playing tour = playedAs(place, "tour", {"tour", place.hill()}, {"--save", place.path("tour.xosc")});
        Playing drive = playedAs(place, "drive", {"play", place.write("drive.xosc", driveText("hill.tif"))});
    };

    static void SetUpTestSuite() { _first = std::make_unique<First>(); }
    static void TearDownTestSuite() { _first.reset(); }

    static const Playing& flown() { return _first->tour; }
    static const Playing& driven() { return _first->drive; }

    /// Where the scenario of the first tour was saved.
    static std::string saved() { return _first->place.path("tour.xosc"); }

    Playing tour(const std::string& name, const std::vector<std::string>& more = {}) const
    {
        return playedAs(_place, name, {"tour", _place.hill()}, more);
    }

    Playing play(const std::string& name, const std::string& scenario,
                 const std::vector<std::string>& more = {}) const
    {
        return playedAs(_place, name, {"play", scenario}, more);
    }

    std::string drive() const { return _place.write("drive.xosc", driveText("hill.tif")); }

    /// Not EXPECT_EQ, which would print the pictures.
    static void expectSame(const Playing& a, const Playing& b)
    {
        EXPECT_EQ(a.frames.size(), 4U);
        EXPECT_TRUE(a.frames == b.frames) << "the pictures differ";
        EXPECT_EQ(withoutMeasured(a.statistics), withoutMeasured(b.statistics));
    }

    Workplace _place;
    inline static std::unique_ptr<First> _first;
};

TEST_F(Determinism, TwoRunsGiveTheSameBytes)
{
    expectSame(driven(), play("drive", drive()));
    const Workplace& place = _first->place; // the scenario names the folder of the terrain
    expectSame(flown(),
               playedAs(place, "again", {"tour", place.hill()}, {"--save", place.path("again.xosc")}));
    EXPECT_EQ(readBytes(saved()), readBytes(place.path("again.xosc")));
}

TEST_F(Determinism, APlayOfTheSavedTourIsTheTour)
{
    expectSame(flown(), play("played", saved()));
}

TEST_F(Determinism, TheNameOfATerrainMakesNoDifference)
{
    // .dem: no suffix that anybody listed; .flt: that of OpenFlight models, too.
    for (const char* name : {"hill.dem", "hill.flt", "hill"})
    {
        std::filesystem::copy_file(_place.hill(), _place.path(name));
        const std::string scenario = _place.path(std::string(name) + ".xosc");
        expectSame(flown(), playedAs(_place, std::string(name) + "-flown", {"tour", _place.path(name)},
                                     {"--save", scenario}));
        expectSame(flown(), play(std::string(name) + "-played", scenario));
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
    EXPECT_FALSE(flown().frames.at("frame_00000.png") == flown().frames.at("frame_00003.png"));
}

TEST_F(Determinism, OtherWeatherGivesOtherPictures)
{
    const std::string text = with(readBytes(saved()), "visualRange=\"60000\"", "visualRange=\"900\"");
    const Playing fog = play("fog", _place.write("fog.xosc", text));
    for (const auto& [name, bytes] : flown().frames)
        EXPECT_FALSE(bytes == fog.frames.at(name)) << name << " shows no fog";
    EXPECT_EQ(withoutMeasured(flown().statistics), withoutMeasured(fog.statistics)) << "fog changed the mesh";
}

TEST_F(Determinism, OneRaisedSampleGivesOtherPictures)
{
    _place.writeHill("same.tif", 0.0);
    _place.writeHill("raised.tif", 50.0);
    expectSame(flown(), play("same", saved(), {"--terrain", _place.path("same.tif")}));
    const Playing raised = play("raised", saved(), {"--terrain", _place.path("raised.tif")});
    EXPECT_FALSE(flown().frames == raised.frames) << "a sample 50 m higher cannot be seen";
}

TEST_F(Determinism, TheChaseCameraIsAnotherEye)
{
    const Playing chase = play("chase", drive(), {"--eye", "chase"});
    EXPECT_FALSE(driven().frames == chase.frames);
    expectSame(chase, play("again", drive(), {"--eye", "chase"}));
}

} // namespace
