// SPDX-License-Identifier: Apache-2.0
// A step of a road's own elevation that no ground can follow.
#include "scenery/roads/TornRoads.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <osgRoads/core/read/ReadNetwork.h>

#include "scenery/roads/CutRoads.h"
#include "scenery/roads/RoadGround.h"

namespace
{

/// A straight road of 600 m whose elevation steps up in its middle.
std::string stepText(double stepM)
{
    return R"(<OpenDRIVE><header revMajor="1" revMinor="7"/>
<road id="1" length="600" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="600"><line/></geometry></planView>
<elevationProfile><elevation s="0" a="3" b="0" c="0" d="0"/><elevation s="300" a=")" +
           std::to_string(3.0 + stepM) + R"(" b="0" c="0" d="0"/></elevationProfile>
<lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="7" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road></OpenDRIVE>)";
}

class TornRoadsTest : public testing::Test
{
protected:
    ~TornRoadsTest() override { std::filesystem::remove(_file); }

    scenery::RoadGround groundOf(double stepM)
    {
        std::ofstream(_file) << stepText(stepM);
        auto ground = scenery::makeRoadGround(_file);
        EXPECT_TRUE(ground) << (ground ? "" : ground.error().message());
        return ground ? std::move(*ground) : scenery::RoadGround{};
    }

    /// The steepest slope between neighbouring samples.
    static double steepest(const osgTerrainROAM::core::HeightField& field)
    {
        double most = 0.0;
        for (int row = 0; row < field.rows; ++row)
            for (int column = 0; column + 1 < field.columns; ++column)
            {
                const auto at = static_cast<std::size_t>(row) * field.columns + column;
                most = std::max<double>(most, std::fabs(field.heightsM[at + 1] - field.heightsM[at]));
            }
        return most / field.spacingEastM;
    }

    std::filesystem::path _file =
        std::filesystem::temp_directory_path() /
        ("torn-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".xodr");
};

} // namespace

TEST_F(TornRoadsTest, AreToldAndTheGroundGoesOverInASlope)
{
    const scenery::RoadGround ground = groundOf(365.0);
    EXPECT_THAT(ground.roads.notes,
                testing::ElementsAre(_file.string() +
                                     ":2: road 1 at s 300: the elevation jumps by 365 m, the ground "
                                     "is left as it is for 200 m on either side; let its pieces meet"));
    EXPECT_LT(steepest(ground.field), 3.0);
    EXPECT_LT(*std::min_element(ground.field.heightsM.begin(), ground.field.heightsM.end()), 4.0F);
    EXPECT_GT(*std::max_element(ground.field.heightsM.begin(), ground.field.heightsM.end()), 360.0F);
}

TEST_F(TornRoadsTest, ASmallStepIsABank)
{
    const scenery::RoadGround ground = groundOf(1.5);
    EXPECT_TRUE(ground.roads.notes.empty());
}

TEST_F(TornRoadsTest, AskNothingOfTheGroundNearTheStep)
{
    const scenery::RoadGround ground = groundOf(365.0);
    const auto& network = ground.roads.placed->network();
    scenery::RoadCutShape shape;
    const auto tile = std::make_shared<osgTerrainROAM::core::RoamTile>(osgTerrainROAM::core::PlacedTile(
        ground.field, {.placement = osgTerrainROAM::core::Placement::planar}));
    const auto isAsked = [&](double s)
    {
        const glm::dvec3 place = ground.roads.placed->surfacePoint(0, s, -3.0);
        return !scenery::roadBand(*ground.roads.placed, tile->tile.frame(), shape, place).isOpen();
    };
    EXPECT_TRUE(isAsked(290.0)); // the bed of a road without this class
    shape.torn = std::make_shared<const scenery::TornRoads>(network);
    EXPECT_FALSE(isAsked(290.0));
    EXPECT_FALSE(isAsked(450.0));
    EXPECT_TRUE(isAsked(50.0));
    EXPECT_TRUE(isAsked(550.0));
}
