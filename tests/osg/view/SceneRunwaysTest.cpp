// SPDX-License-Identifier: Apache-2.0
// Which lines of a map are runways and taxiways of the scene.
#include "scene/SceneRunways.h"

#include <gtest/gtest.h>

#include "FeatureText.h"

namespace
{

using namespace trainer;
using namespace featuretext;

/// The airfields of a map with a runway of 600 m and besides what is named.
SceneAirfields airfieldsWith(std::vector<std::string> features, bool hasRunway = true)
{
    const Folder folder("scene-runways");
    if (hasRunway)
        features.push_back(lineFeature(R"("aeroway":"runway","ref":"09/27")", {{50, 300}, {650, 300}}));
    osgTerrainROAM::core::RoamFile description;
    description.features = {folder.write("map.geojson", collection(features))};
    const auto airfields = sceneAirfields(description, osgTerrainROAM::core::RoamTile(planarTile()));
    EXPECT_TRUE(airfields) << airfields.error().message();
    return airfields ? *airfields : SceneAirfields{};
}

std::string leadingToTheRunway(const std::string& tags)
{
    return lineFeature(tags, {{200, 300}, {200, 400}});
}

TEST(SceneRunways, TaxiwaysAreThoseThatTheMapCallsSo)
{
    const SceneAirfields airfields =
        airfieldsWith({leadingToTheRunway(R"("aeroway":"taxiway","width":"7.5")")});
    ASSERT_EQ(airfields.taxiways.size(), 1U);
    EXPECT_EQ(airfields.taxiways[0].widthM, 7.5);
    ASSERT_EQ(airfields.runways.size(), 1U);
    EXPECT_EQ(airfields.runways[0].designators, "09/27");
    // No lamps along these, however wide.
    for (const char* tags : {R"("aeroway":"taxilane","width":"18")", R"("highway":"service","width":"15")",
                             R"("aeroway":"taxiway","surface":"grass")"})
        EXPECT_TRUE(airfieldsWith({leadingToTheRunway(tags)}).taxiways.empty()) << tags;
}

TEST(SceneRunways, ATaxiwayLeadsToARunwayOrToOneThatDoes)
{
    const std::string near = leadingToTheRunway(R"("aeroway":"taxiway")"),
                      next = lineFeature(R"("aeroway":"taxiway")", {{200, 400}, {400, 400}}),
                      alone = lineFeature(R"("aeroway":"taxiway")", {{500, 500}, {600, 600}});
    EXPECT_EQ(airfieldsWith({next, near, alone}).taxiways.size(), 2U);
    EXPECT_TRUE(airfieldsWith({next, near}, false).taxiways.empty());
}

} // namespace
