// SPDX-License-Identifier: Apache-2.0
// What is kept of a scene besides its objects comes back as it was, and nothing of damaged bytes does.
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "scene/SceneRunways.h"
#include "scenery/lights/StreetLampBytes.h"

namespace
{

using scenery::streetLampsIn;
using trainer::bytesOf;
using trainer::sceneAirfieldsIn;

trainer::SceneAirfields airfield()
{
    trainer::SceneAirfields airfields;
    airfields.runways = {{{{100.0, -50.0}, 30.0, 1200.0, 30.0}, "03/21", true},
                         {{{0.0, 0.0}, 270.0, 500.0, 20.0}, "", false}};
    airfields.holds = {{{1.0, 2.0}, {0.6, 0.8}, 15.0, 740.0, "09-27"}};
    airfields.taxiways = {{{{1.0, 2.0}, {3.0, 4.0}, {5.0, 6.0}}, 15.0}, {{{7.0, 8.0}}, 10.5}};
    return airfields;
}

TEST(KeptScene, AirfieldsComeBack)
{
    const std::string bytes = bytesOf(airfield());
    const auto read = sceneAirfieldsIn(bytes);
    ASSERT_TRUE(read);
    EXPECT_EQ(bytesOf(*read), bytes);
    ASSERT_EQ(read->runways.size(), 2U);
    EXPECT_EQ(read->runways[0].designators, "03/21");
    EXPECT_EQ(read->runways[0].strip.lengthM, 1200.0);
    EXPECT_FALSE(read->runways[1].isPaved);
    ASSERT_EQ(read->taxiways.size(), 2U);
    EXPECT_EQ(read->taxiways[0].middle[2], glm::dvec2(5.0, 6.0));
    ASSERT_EQ(read->holds.size(), 1U);
    EXPECT_EQ(read->holds[0].runways, "09-27");
    EXPECT_EQ(read->holds[0].away, glm::dvec2(0.6, 0.8));
    EXPECT_EQ(read->holds[0].runwayM, 740.0);
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_FALSE(sceneAirfieldsIn(bytes.substr(0, size))) << size;
    EXPECT_FALSE(sceneAirfieldsIn(bytes + "x"));
    trainer::SceneAirfields noLine = airfield();
    noLine.taxiways[1].middle.clear();
    EXPECT_FALSE(sceneAirfieldsIn(bytesOf(noLine)));
    trainer::SceneAirfields tooShort = airfield();
    tooShort.runways[0].strip.lengthM = 1.0;
    EXPECT_FALSE(sceneAirfieldsIn(bytesOf(tooShort)));
    trainer::SceneAirfields noPlace = airfield();
    noPlace.runways[0].strip.threshold.y = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(sceneAirfieldsIn(bytesOf(noPlace)));
}

TEST(KeptScene, StreetLampsComeBack)
{
    const std::vector<scenery::StreetLamp> lamps{{{1.0, 2.0}, {0.0, 1.0}, 6.0, true},
                                                 {{3.0, 4.0}, {-1.0, 0.0}, 8.0, false}};
    const std::string bytes = bytesOf(lamps);
    const auto read = streetLampsIn(bytes);
    ASSERT_TRUE(read);
    EXPECT_EQ(bytesOf(*read), bytes);
    EXPECT_TRUE(read->front().isSodium);
    EXPECT_EQ(read->back().place, glm::dvec2(3.0, 4.0));
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_FALSE(streetLampsIn(bytes.substr(0, size))) << size;
    EXPECT_FALSE(streetLampsIn(bytes + "x"));
    auto nowhere = lamps;
    nowhere[0].place.x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(streetLampsIn(bytesOf(nowhere)));
}

} // namespace
