// SPDX-License-Identifier: Apache-2.0
// Marks, signals, objects, junctions and the geoReference, worked by hand.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <osgRoads/core/query/GeoReference.h>
#include <osgRoads/core/query/MarkStrokes.h>
#include <osgRoads/core/query/ObjectInstances.h>

#include "RoadTexts.h"

namespace
{

using namespace osgRoads::core;
using namespace roadtexts;

std::string markedLanes(const std::string& marks)
{
    return "<lanes><laneSection s=\"0\"><center><lane id=\"0\" type=\"none\" level=\"false\">" + marks +
           "</lane></center><right><lane id=\"-1\" type=\"driving\" level=\"false\">" + kWidth +
           "</lane></right></laneSection></lanes>\n";
}

std::vector<MarkStroke> strokesOf(const RoadNetwork& read)
{
    const Road& on = read.roads.front();
    return markStrokes(on, on.sections.front(), on.sections.front().centre);
}

TEST(MarkStrokes, BrokenAndSolidByType)
{
    const RoadNetwork read = sound(network(road(
        "1", 20.0,
        straightPlan(20.0) + markedLanes(R"(<roadMark sOffset="0" type="broken" weight="bold" color="yellow"/>
<roadMark sOffset="12" type="solid solid" weight="standard" color="white" width="0.2"/>)"))));
    const std::vector<MarkStroke> strokes = strokesOf(read);
    ASSERT_EQ(strokes.size(), 4u); // dashes at 0 and 9, two lines from 12
    EXPECT_DOUBLE_EQ(strokes[1].sStart, 9.0);
    EXPECT_DOUBLE_EQ(strokes[1].sEnd, 12.0);
    EXPECT_DOUBLE_EQ(strokes[0].width, kBoldMarkWidthM);
    EXPECT_EQ(strokes[0].colour, MarkColour::yellow);
    EXPECT_DOUBLE_EQ(strokes[2].tOffset, 0.5 * (0.2 + kDoubleSpaceM));
    EXPECT_DOUBLE_EQ(strokes[3].tOffset, -0.5 * (0.2 + kDoubleSpaceM));
    EXPECT_DOUBLE_EQ(strokes[3].sEnd, 20.0);
}

TEST(MarkStrokes, LinesOfTheTypeRepeat)
{
    const RoadNetwork read = sound(network(road(
        "1", 20.0,
        straightPlan(20.0) +
            markedLanes(
                R"(<roadMark sOffset="0" type="custom" weight="standard" color="standard"><type name="x" width="0.3">
<line length="2" space="4" tOffset="0.5" sOffset="1" rule="caution"/></type></roadMark>)"))));
    const std::vector<MarkStroke> strokes = strokesOf(read);
    ASSERT_EQ(strokes.size(), 4u); // at 1, 7, 13, 19
    EXPECT_DOUBLE_EQ(strokes[3].sStart, 19.0);
    EXPECT_DOUBLE_EQ(strokes[3].sEnd, 20.0);
    EXPECT_DOUBLE_EQ(strokes[3].width, 0.3);
    EXPECT_DOUBLE_EQ(strokeT(read.roads[0], read.roads[0].sections[0], strokes[0], 2.0), 0.5);
}

/// Explicit lines are painted once, where they say; sway moves them sideways.
TEST(MarkStrokes, ExplicitLinesAndSway)
{
    const RoadNetwork read = sound(network(road(
        "1", 20.0,
        straightPlan(20.0) +
            markedLanes(
                R"(<roadMark sOffset="2" type="solid" weight="standard" color="standard"><sway ds="0" a="0" b="0.1" c="0" d="0"/>
<explicit><line length="3" tOffset="0.25" sOffset="4" width="0.15" rule="none"/><line length="1" tOffset="0" sOffset="9"/></explicit></roadMark>)"))));
    const std::vector<MarkStroke> strokes = strokesOf(read);
    ASSERT_EQ(strokes.size(), 2u);
    EXPECT_DOUBLE_EQ(strokes[0].sStart, 6.0);
    EXPECT_DOUBLE_EQ(strokes[0].sEnd, 9.0);
    EXPECT_DOUBLE_EQ(strokes[0].width, 0.15);
    EXPECT_DOUBLE_EQ(strokes[1].width, kMarkWidthM);
    EXPECT_DOUBLE_EQ(strokeT(read.roads[0], read.roads[0].sections[0], strokes[0], 7.0), 0.25 + 0.5);
}

/// A pattern of a hundred-millionth of a metre is one stroke.
TEST(MarkStrokes, TinyPatternsAreOneStroke)
{
    const RoadNetwork read = sound(network(
        road("1", 20.0,
             straightPlan(20.0) +
                 markedLanes(R"(<roadMark sOffset="0" type="broken" weight="standard" color="standard">
<type name="x" width="0.1"><line length="1e-8" space="1e-8" tOffset="0" sOffset="0"/></type></roadMark>)"))));
    EXPECT_EQ(strokesOf(read).size(), 1u);
}

TEST(ObjectInstances, RepeatsAreInterpolated)
{
    const RoadNetwork read = sound(network(road("1", 100.0, straightPlan(100.0) + twoLanes() + R"(<objects>
<object id="o" type="pole" s="10" t="5" zOffset="0.1" orientation="none" height="2" radius="0.1">
<repeat s="10" length="40" distance="20" tStart="5" tEnd="7" heightStart="2" heightEnd="4" zOffsetStart="0" zOffsetEnd="1"/>
<repeat s="60" length="30" distance="0" tStart="-5" tEnd="-6" heightStart="1" heightEnd="1" zOffsetStart="0" zOffsetEnd="0"/>
</object></objects>)")));
    const std::vector<ObjectInstance> found = objectInstances(read.roads[0].objects[0]);
    ASSERT_EQ(found.size(), 4u);
    EXPECT_DOUBLE_EQ(found[1].s, 30.0);
    EXPECT_DOUBLE_EQ(found[1].t, 6.0);
    EXPECT_DOUBLE_EQ(found[1].height, 3.0);
    EXPECT_DOUBLE_EQ(found[1].z, 0.5);
    EXPECT_DOUBLE_EQ(found[1].radius, 0.1);
    EXPECT_TRUE(found[3].isStretch);
    EXPECT_DOUBLE_EQ(found[3].sEnd, 90.0);
    EXPECT_DOUBLE_EQ(found[3].tEnd, -6.0);
}

TEST(ObjectInstances, OutlinesOnTheRoadAndInTheFrameOfTheObject)
{
    const RoadNetwork read = sound(network(road("1", 100.0, straightPlan(100.0) + twoLanes() + R"(<objects>
<object id="o" type="building" s="20" t="10" zOffset="1" hdg="1.5707963267948966" orientation="none"><outlines>
<outline id="0" closed="true"><cornerLocal u="2" v="1" z="0" height="3"/><cornerRoad s="30" t="-4" dz="0.5" height="3"/></outline>
</outlines></object></objects>)")));
    const RoadObject& object = read.roads[0].objects[0];
    const std::vector<glm::dvec3> corners = outlineCorners(read.roads[0], object, object.outlines[0]);
    ASSERT_EQ(corners.size(), 2u);
    EXPECT_NEAR(corners[1].x, 20.0 - 1.0, 1e-12); // v points against x when u points along y
    EXPECT_NEAR(corners[1].y, 12.0, 1e-12);
    EXPECT_NEAR(corners[1].z, 1.0, 1e-12);
    EXPECT_NEAR(corners[0].x, 30.0, 1e-12);
    EXPECT_NEAR(corners[0].y, -4.0, 1e-12);
    EXPECT_NEAR(corners[0].z, 0.5, 1e-12);
}

TEST(RoadContent, SignalsAndControllers)
{
    const RoadNetwork read = sound(network(road("1", 100.0, straightPlan(100.0) + twoLanes() + R"(<signals>
<signal id="a" name="Limit" s="20" t="-5" zOffset="2" orientation="+" dynamic="no" country="DE" countryRevision="2017" type="274" subtype="55" value="50" unit="km/h" hOffset="0.1" pitch="0" roll="0" width="0.6" height="0.6">
<validity fromLane="-1" toLane="-1"/><dependency id="b" type="x"/><positionInertial x="1" y="2" z="3" hdg="0.5"/></signal>
<signal id="b" s="90" t="4" orientation="-" dynamic="yes" type="1000001"/>
<signalReference id="a" s="50" t="1" orientation="none"/></signals>)") +
                                           "<controller id=\"c\" name=\"lights\" sequence=\"1\"><control "
                                           "signalId=\"b\" type=\"0\"/></controller>\n"));
    const Road& on = read.roads[0];
    ASSERT_EQ(on.signals.size(), 2u);
    EXPECT_EQ(on.signals[0].orientation, '+');
    EXPECT_DOUBLE_EQ(on.signals[0].value.value(), 50.0);
    EXPECT_EQ(on.signals[0].validities[0].fromLane, -1);
    EXPECT_DOUBLE_EQ(on.signals[0].post->z, 3.0);
    EXPECT_TRUE(on.signals[1].isDynamic);
    EXPECT_FALSE(on.signals[1].value);
    EXPECT_EQ(on.signalReferences[0].orientation, '0');
    EXPECT_EQ(read.controllers[0].controls[0].signalId, "b");
}

TEST(RoadContent, LanesKeepSpeedsAccessAndMaterial)
{
    const std::string content =
        std::string(R"(<lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right>
<lane id="-1" type="HOV" level="false" direction="reversed">)") +
        kWidth +
        R"(<speed sOffset="0" max="90" unit="km/h"/><speed sOffset="10" max="no limit"/>
<access sOffset="0" rule="deny" restriction="trucks"/><material sOffset="5" surface="asphalt" friction="0.8" roughness="0.015"/>
<rule sOffset="0" value="no stopping at any time"/></lane></right></laneSection></lanes>)";
    const RoadNetwork read = sound(network(
        road("1", 100.0,
             straightPlan(100.0) +
                 "<type s=\"0\" type=\"motorway\" country=\"DE\"><speed max=\"130\" unit=\"km/h\"/></type>" +
                 content)));
    const Lane& lane = read.roads[0].sections[0].right[0];
    EXPECT_EQ(lane.type, LaneType::hov);
    EXPECT_EQ(lane.direction, LaneDirection::reversed);
    EXPECT_DOUBLE_EQ(lane.speeds[0].metresPerSecond.value(), 25.0);
    EXPECT_FALSE(lane.speeds[1].metresPerSecond);
    EXPECT_EQ(lane.access[0].restriction, "trucks");
    EXPECT_DOUBLE_EQ(lane.materials[0].friction, 0.8);
    EXPECT_NEAR(read.roads[0].kinds[0].metresPerSecond.value(), 130.0 / 3.6, 1e-12);
}

TEST(RoadContent, JunctionTypesAndPriorities)
{
    const RoadNetwork read = sound(network(
        road("1", 50.0, straightPlan(50.0) + twoLanes()) +
        R"(<junction id="d" type="direct"><connection id="0" incomingRoad="1" linkedRoad="1" contactPoint="end"><laneLink from="-1" to="-1" overlapZone="3"/></connection></junction>
<junction id="v" type="virtual" mainRoad="1" sStart="10" sEnd="20" orientation="+"><priority high="1" low="2"/><controller id="c" type="0"/></junction>)"));
    EXPECT_EQ(read.junctions[0].type, JunctionType::direct);
    EXPECT_EQ(read.junctions[0].connections[0].connectingRoad, 0);
    EXPECT_EQ(read.junctions[0].connections[0].contactPoint, ContactPoint::end);
    EXPECT_EQ(read.junctions[1].type, JunctionType::isVirtual);
    EXPECT_DOUBLE_EQ(read.junctions[1].sEnd, 20.0);
    EXPECT_EQ(read.junctions[1].priorities[0].high, "1");
}

/// UTM zone 32 has its central meridian at 9° E, with 500 km of false easting and a scale of 0.9996 there.
TEST(GeoReference, GoesToDegreesAndBack)
{
    NetworkHeader header;
    header.geoReference = "+proj=utm +zone=32 +ellps=WGS84 +datum=WGS84 +units=m +no_defs";
    header.offsetX = 500000.0;
    header.offsetY = 5000000.0;
    header.offsetZ = 100.0;
    const auto reference = GeoReference::create(header, "a.xodr");
    ASSERT_TRUE(reference) << reference.error().message();
    const auto degrees = reference->toGeodetic({0.0, 0.0, 12.0});
    ASSERT_TRUE(degrees);
    EXPECT_NEAR(degrees->longitudeDeg, 9.0, 1e-12);
    EXPECT_NEAR(degrees->latitudeDeg, 45.15, 0.01);
    EXPECT_DOUBLE_EQ(degrees->heightM, 112.0);
    const auto back = reference->toInertial(*degrees);
    ASSERT_TRUE(back);
    EXPECT_NEAR(back->x, 0.0, 1e-6);
    EXPECT_NEAR(back->y, 0.0, 1e-6);
    EXPECT_DOUBLE_EQ(back->z, 12.0);
    header.offsetHeadingRad = 0.3;
    const auto turned = GeoReference::create(header, "a.xodr");
    const auto there = turned->toInertial(turned->toGeodetic({700.0, -300.0, 1.0}).value());
    EXPECT_NEAR(there->x, 700.0, 1e-6);
    EXPECT_NEAR(there->y, -300.0, 1e-6);
}

TEST(GeoReference, TellsWhatIsMissing)
{
    NetworkHeader header;
    EXPECT_EQ(GeoReference::create(header, "a.xodr").error().what, "the header has no geoReference");
    header.geoReference = "+proj=nonsense";
    EXPECT_EQ(
        GeoReference::create(header, "a.xodr").error().message(),
        "a.xodr: PROJ does not know the geoReference \"+proj=nonsense\"; write a PROJ string or EPSG:code");
}

} // namespace
