// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/land/ParkedAircraft.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "scenery/buildings/Outline.h"
#include "worldmaking/land/ModelPoints.h"

namespace
{

using namespace worldmaking;

/// An airfield in the plane of metres about 46.5° N, 8.5° E.
class MadeAirfield
{
public:
    MadeAirfield() { _map.shapes.push_back({0, ShapeForm::point, {{{8.5, 46.5}}}, {}}); }

    void add(ShapeForm form, const std::vector<glm::dvec2>& path, Tags tags)
    {
        LandShape shape;
        shape.id = static_cast<std::int64_t>(_map.shapes.size());
        shape.form = form;
        shape.tags = std::move(tags);
        shape.paths.emplace_back();
        for (const glm::dvec2& place : path)
            shape.paths.front().push_back(*_plane.toDegrees(place));
        _map.shapes.push_back(std::move(shape));
    }

    void addApron(double lengthM, double depthM)
    {
        add(ShapeForm::area, {{0.0, 0.0}, {lengthM, 0.0}, {lengthM, depthM}, {0.0, depthM}},
            {{"aeroway", "apron"}});
    }

    void addRunway(double lengthM)
    {
        add(ShapeForm::line, {{0.0, -200.0}, {lengthM, -200.0}}, {{"aeroway", "runway"}});
    }

    struct Found
    {
        std::string model;
        glm::dvec2 place{0.0};
        double headingDeg = 0.0;
    };

    std::vector<Found> parked() const
    {
        std::vector<Found> found;
        for (const LandShape& shape : parkedAircraft(_map, _plane))
        {
            EXPECT_TRUE(namesModel(shape));
            found.push_back({shape.tags.at("model"), *_plane.toPlan(shape.paths.front().front()),
                             std::stod(shape.tags.at("heading"))});
        }
        return found;
    }

private:
    static MapPlane planeHere()
    {
        LandMap middle;
        middle.shapes.push_back({0, ShapeForm::point, {{{8.5, 46.5}}}, {}});
        return *MapPlane::create(planeAbout(middle), "here");
    }

    MapPlane _plane = planeHere();
    LandMap _map;
};

} // namespace

TEST(ParkedAircraft, StandOnAnApronApartFromEachOtherWithTheirNosesInwards)
{
    MadeAirfield field;
    field.addRunway(900.0);
    field.addApron(260.0, 60.0);
    const auto parked = field.parked();
    EXPECT_GE(parked.size(), 8u);
    EXPECT_LE(parked.size(), 26u) << "some places stay free";
    for (const auto& one : parked)
    {
        EXPECT_EQ(one.model, "light-aircraft");
        const bool isInNorth = one.place.y > 30.0;
        EXPECT_NEAR(one.headingDeg, isInNorth ? 180.0 : 0.0, 1.0);
        EXPECT_GT(std::min(one.place.y, 60.0 - one.place.y), 4.0);
        for (const auto& other : parked)
            EXPECT_TRUE(&other == &one || glm::distance(one.place, other.place) > 12.0);
    }
}

TEST(ParkedAircraft, KeepAwayFromTaxiwaysAndGates)
{
    MadeAirfield field;
    field.addApron(260.0, 60.0);
    const std::size_t freely = field.parked().size();
    field.add(ShapeForm::line, {{-50.0, 8.0}, {300.0, 8.0}}, {{"aeroway", "taxiway"}});
    field.add(ShapeForm::area, {{100.0, 61.0}, {130.0, 61.0}, {130.0, 90.0}, {100.0, 90.0}},
              {{"building", "hangar"}});
    const auto parked = field.parked();
    EXPECT_LT(parked.size(), freely);
    EXPECT_FALSE(parked.empty());
    for (const auto& one : parked)
    {
        EXPECT_GT(one.place.y, 30.0) << "the row at the taxiway is empty";
        EXPECT_FALSE(one.place.x > 92.0 && one.place.x < 138.0) << "before the gate: " << one.place.x;
    }
}

TEST(ParkedAircraft, AirlinersNeedALargeApronAndALongRunway)
{
    for (const auto& [runwayM, depthM, model] : {std::tuple(2500.0, 110.0, "airliner"),
                                                 {900.0, 110.0, "light-aircraft"},
                                                 {2500.0, 60.0, "light-aircraft"}})
    {
        MadeAirfield field;
        field.addRunway(runwayM);
        field.addApron(500.0, depthM);
        const auto parked = field.parked();
        ASSERT_FALSE(parked.empty());
        for (const auto& one : parked)
            EXPECT_EQ(one.model, model) << runwayM << ' ' << depthM;
    }
}

TEST(ParkedAircraft, TakeTheParkingPositionsOfTheMap)
{
    MadeAirfield field;
    field.addApron(400.0, 60.0);
    for (double east = 30.0; east < 390.0; east += 20.0)
        field.add(ShapeForm::line, {{east, 30.0}, {east, 45.0}}, {{"aeroway", "parking_position"}});
    const auto parked = field.parked();
    EXPECT_GE(parked.size(), 4u);
    EXPECT_LE(parked.size(), 16u) << "of eighteen";
    for (const auto& one : parked)
    {
        EXPECT_NEAR(one.headingDeg, 0.0, 1.0);
        EXPECT_NEAR(one.place.y, 45.0 - 4.1, 0.1) << "the nose at the end of the line";
        EXPECT_NEAR(std::remainder(one.place.x - 30.0, 20.0), 0.0, 0.1);
    }
}

TEST(ParkedAircraft, HelicoptersStandOnSomeHelipads)
{
    MadeAirfield field;
    for (int i = 0; i < 40; ++i)
        field.add(ShapeForm::point, {{60.0 * i, 0.0}}, {{"aeroway", "helipad"}});
    const auto parked = field.parked();
    EXPECT_GE(parked.size(), 5u);
    EXPECT_LE(parked.size(), 25u);
    for (const auto& one : parked)
        EXPECT_EQ(one.model, "helicopter");
}

TEST(ParkedAircraft, TheSameMapGivesTheSameAndNoApronNone)
{
    MadeAirfield field;
    EXPECT_TRUE(field.parked().empty());
    field.addApron(120.0, 30.0);
    const auto once = field.parked(), again = field.parked();
    ASSERT_EQ(once.size(), again.size());
    for (std::size_t i = 0; i < once.size(); ++i)
        EXPECT_EQ(once[i].place, again[i].place);
    for (const auto& one : once)
        EXPECT_GT(one.place.y, 15.0) << "two rows have no room";
}
