// SPDX-License-Identifier: Apache-2.0
// Typical mistakes of OpenDRIVE files, each with the line that a person is told.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ToldLines.h"

namespace
{

using namespace roadtexts;
using testing::Contains;
using testing::Eq;

std::string withLink(const std::string& link)
{
    return network(road("1", 50.0, "<link>" + link + "</link>\n" + straightPlan(50.0) + twoLanes()));
}

TEST(RoadErrors, ASoundNetworkHasNone)
{
    EXPECT_EQ(told(network(plainRoad("1"))), std::vector<std::string>{});
}

/// The mutation of the form that every message has: one without its line, and one without a remedy.
TEST(RoadErrors, AMessageWithoutLineOrRemedyIsNoMessage)
{
    const testing::Matcher<std::string> isMessage = testing::MatchesRegex(kMessage);
    EXPECT_TRUE(isMessage.Matches("a.xodr:3: there is no road; add one"));
    EXPECT_FALSE(isMessage.Matches("a.xodr: there is no road; add one"));
    EXPECT_FALSE(isMessage.Matches("a.xodr:3: there is no road"));
}

TEST(RoadErrors, NotXml)
{
    EXPECT_THAT(told("<OpenDRIVE>\n<road></OpenDRIVE>"),
                Contains(testing::StartsWith("a.xodr:2: not well-formed XML: ")));
}

TEST(RoadErrors, EntitiesAreNotExpandedAndNestingIsBounded)
{
    std::string bomb =
        "<?xml version=\"1.0\"?><!DOCTYPE a [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;\">]>\n";
    EXPECT_EQ(told(bomb + replaced(network(plainRoad("1")), "id=\"1\"", "id=\"&b;\"")),
              std::vector<std::string>{});
    std::string deep;
    for (int i = 0; i < 100000; ++i)
        deep += "<a>\n";
    EXPECT_THAT(told("<OpenDRIVE>" + deep), Contains(testing::HasSubstr("not well-formed XML")));
    for (int i = 0; i < 100000; ++i)
        deep += "</a>";
    EXPECT_THAT(told("<OpenDRIVE>" + deep + "</OpenDRIVE>"),
                Contains(Eq("a.xodr:64: elements are nested deeper than 64; flatten the file")));
}

TEST(RoadErrors, AnotherFormat)
{
    EXPECT_THAT(
        told("<OpenSCENARIO/>"),
        Contains(Eq("a.xodr:1: the root element is OpenSCENARIO, not OpenDRIVE; name an OpenDRIVE file")));
    EXPECT_THAT(told(replaced(network(plainRoad("1")), "revMajor=\"1\"", "revMajor=\"2\"")),
                Contains(Eq("a.xodr:2: version 2 of OpenDRIVE; convert it to 1.4 to 1.8")));
}

TEST(RoadErrors, NoRoad)
{
    EXPECT_THAT(told(network("")), Contains(Eq("a.xodr:1: there is no road; add one")));
    EXPECT_THAT(
        told(network(road("1", 50.0, twoLanes()))),
        Contains(Eq("a.xodr:3: no road can be used: road 1: there is no geometry in planView; add one; the "
                    "road is left out")));
}

TEST(RoadErrors, NumbersThatAreNone)
{
    const std::string text = network(plainRoad("1"));
    EXPECT_THAT(
        told(replaced(text, "hdg=\"0\"", "hdg=\"nan\"")),
        Contains(Eq("a.xodr:4: road 1: geometry/hdg is not a finite number: \"nan\"; write a number within "
                    "±1e12; 0 is used")));
    EXPECT_THAT(told(replaced(text, "a=\"3.5\"", "a=\"1e999\"")),
                Contains(testing::HasSubstr("width/a is not a finite number: \"1e999\"")));
    EXPECT_THAT(told(replaced(text, "x=\"0\" ", "")),
                Contains(Eq("a.xodr:4: road 1: geometry has no attribute x; add it")));
}

TEST(RoadErrors, LengthsThatCannotBe)
{
    const std::string sound = plainRoad("1");
    EXPECT_THAT(
        told(network(sound + road("2", -5.0, straightPlan(50.0) + twoLanes()))),
        Contains(Eq("a.xodr:9: road 2: the road is -5 m long; write a length above 0; the road is left "
                    "out")));
    EXPECT_THAT(told(network(sound + road("2", 3e9, straightPlan(50.0) + twoLanes()))),
                Contains(Eq("a.xodr:9: road 2: the road is 3e+09 m long; correct its length: longer than "
                            "1e6 m it is left out")));
    EXPECT_THAT(told(network(road("1", 60.0, straightPlan(50.0) + twoLanes()))),
                Contains(Eq("a.xodr:3: road 1: the plan view ends at 50 m, the road at 60 m; make both "
                            "equal; the lesser is used")));
}

TEST(RoadErrors, GeometryWithoutShape)
{
    EXPECT_THAT(
        told(network(road("1", 50.0,
                          "<planView>" + geometry(R"(s="0" x="0" y="0" hdg="0")", 50.0, "") +
                              "</planView>\n" + twoLanes()))),
        Contains(Eq("a.xodr:4: road 1: geometry has no shape; add line, arc, spiral or paramPoly3; a line is "
                    "used")));
}

TEST(RoadErrors, CurvesThatWindTooOften)
{
    EXPECT_THAT(
        told(network(road("1", 50.0,
                          "<planView>" +
                              geometry(R"(s="0" x="0" y="0" hdg="0")", 50.0, R"(<arc curvature="1e9"/>)") +
                              "</planView>\n" + twoLanes()))),
        Contains(testing::HasSubstr("road 1: arc turns by 5e+10 rad; check curvature and length; "
                                    "a line is used")));
}

TEST(RoadErrors, GapAndKinkBetweenElements)
{
    const std::string plan = "<planView>" + geometry(R"(s="0" x="0" y="0" hdg="0")", 25.0, "<line/>") +
                             geometry(R"(s="25" x="25" y="0.5" hdg="0.25")", 25.0, "<line/>") +
                             "</planView>\n";
    const auto lines = told(network(road("1", 50.0, plan + twoLanes())));
    EXPECT_THAT(
        lines,
        Contains(Eq("a.xodr:3: road 1 at s 25: the geometry has a gap of 0.5 m; let the elements meet")));
    EXPECT_THAT(lines,
                Contains(Eq("a.xodr:3: road 1 at s 25: the geometry has a kink of 0.25 rad; let the headings "
                            "meet")));
}

TEST(RoadErrors, DanglingLinks)
{
    EXPECT_THAT(
        told(withLink(R"(<successor elementType="road" elementId="9" contactPoint="start"/>)")),
        Contains(Eq("a.xodr:4: road 1: the successor is road 9, which is not there; correct the id or remove "
                    "the link")));
    EXPECT_THAT(
        told(withLink(R"(<predecessor elementType="junction" elementId="9"/>)")),
        Contains(Eq("a.xodr:4: road 1: the predecessor is junction 9, which is not there; correct the id or "
                    "remove the link")));
}

TEST(RoadErrors, CircularLink)
{
    EXPECT_THAT(
        told(withLink(R"(<successor elementType="road" elementId="1" contactPoint="end"/>)")),
        Contains(
            Eq("a.xodr:4: road 1: the end of the road is linked to itself; link it to another road, or to "
               "its other end")));
}

TEST(RoadErrors, MissingContactPointAndUnknownType)
{
    EXPECT_THAT(
        told(withLink(R"(<successor elementType="road" elementId="1"/>)")),
        Contains(
            Eq("a.xodr:4: road 1: the successor has no contactPoint; write start or end; start is used")));
    EXPECT_THAT(told(withLink(R"(<successor elementType="path" elementId="1" contactPoint="start"/>)")),
                Contains(testing::HasSubstr("successor/elementType has the unknown value \"path\"")));
}

TEST(RoadErrors, MissingPredecessor)
{
    const std::string first =
        road("1", 50.0,
             "<link><successor elementType=\"road\" elementId=\"2\" contactPoint=\"start\"/></link>\n" +
                 straightPlan(50.0) + twoLanes());
    const std::string second =
        road("2", 50.0, replaced(straightPlan(50.0), "x=\"0\"", "x=\"50\"") + twoLanes());
    EXPECT_THAT(
        told(network(first + second)),
        Contains(Eq("a.xodr:4: road 1 is linked to the start of road 2, which is not linked back; add road 1 "
                    "to the links of road 2")));
}

TEST(RoadErrors, LaneLinkToNoLane)
{
    const std::string link =
        "<link><successor elementType=\"road\" elementId=\"2\" contactPoint=\"start\"/></link>\n";
    const std::string lanes =
        replaced(twoLanes(), "<lane id=\"-1\" type=\"driving\" level=\"false\">",
                 "<lane id=\"-1\" type=\"driving\" level=\"false\"><link><successor id=\"-4\"/></link>");
    EXPECT_THAT(
        told(network(road("1", 50.0, link + straightPlan(50.0) + lanes) +
                     road("2", 50.0, replaced(straightPlan(50.0), "x=\"0\"", "x=\"50\"") + twoLanes()))),
        Contains(
            testing::HasSubstr("road 1 links to lane -4 of road 2, which is not there; correct the id of "
                               "the lane")));
}

TEST(RoadErrors, UnknownWords)
{
    const std::string text = network(plainRoad("1"));
    EXPECT_THAT(
        told(replaced(text, "type=\"driving\"", "type=\"hovering\"")),
        Contains(Eq("a.xodr:6: road 1: lane/type has the unknown value \"hovering\"; use a word of the "
                    "standard")));
    EXPECT_THAT(told(replaced(text, "junction=\"-1\"", "junction=\"-1\" rule=\"MIDDLE\"")),
                Contains(testing::HasSubstr("road/rule has the unknown value \"MIDDLE\"")));
}

TEST(RoadErrors, LaneIds)
{
    const std::string text = network(plainRoad("1"));
    EXPECT_THAT(
        told(replaced(text, "<lane id=\"1\"", "<lane id=\"2\"")),
        Contains(
            Eq("a.xodr:6: road 1: lane 2 has no lane inside it; number the lanes without gaps; it is left "
               "out")));
    EXPECT_THAT(
        told(replaced(text, "<lane id=\"1\"", "<lane id=\"-1\"")),
        Contains(
            Eq("a.xodr:6: road 1: lane -1 stands on the wrong side; left lanes are positive, right lanes "
               "negative")));
    const std::string twice = std::string("<lane id=\"-1\" type=\"stop\">") + kWidth + "</lane></right>";
    EXPECT_THAT(told(replaced(text, "</right>", twice)),
                Contains(testing::HasSubstr("lane -1 is there twice; remove one; the first is used")));
}

TEST(RoadErrors, LaneWidths)
{
    const std::string text = network(plainRoad("1"));
    EXPECT_THAT(
        told(replaced(text, "b=\"0\"", "b=\"-0.1\"")),
        Contains(Eq("a.xodr:6: road 1: lane 1 has a negative width down to -1.5 m; correct its width; 0 "
                    "is used there")));
    EXPECT_THAT(told(replaced(text, kWidth, "")),
                Contains(Eq("a.xodr:6: road 1: lane 1 of the section at s 0 has neither width nor border; "
                            "add a width; 0 is used")));
    EXPECT_THAT(told(replaced(text, "sOffset=\"0\"", "sOffset=\"4\"")),
                Contains(testing::HasSubstr("the width of lane 1 begins at sOffset 4; begin it at 0")));
}

TEST(RoadErrors, SectionsThatDoNotAscendOrHaveNoCentre)
{
    const std::string section =
        "<laneSection s=\"0\"><center><lane id=\"0\" type=\"none\"/></center></laneSection>";
    const std::string later =
        "<laneSection s=\"20\"><center><lane id=\"0\" type=\"none\"/></center></laneSection>";
    EXPECT_THAT(
        told(network(road("1", 50.0, straightPlan(50.0) + "<lanes>" + later + section + "</lanes>"))),
        Contains(Eq("a.xodr:5: road 1: the laneSection entries do not ascend; sort them by their start")));
    EXPECT_THAT(told(network(road("1", 50.0, straightPlan(50.0) + "<lanes><laneSection s=\"0\"/></lanes>"))),
                Contains(Eq("a.xodr:5: road 1: the lane section has no centre lane; add lane 0")));
    EXPECT_THAT(told(network(road("1", 50.0, straightPlan(50.0)))),
                Contains(Eq("a.xodr:3: road 1: there is no lane section; add one; the road has no surface")));
}

TEST(RoadErrors, IdsThatAreThereTwice)
{
    EXPECT_THAT(
        told(network(plainRoad("1") + plainRoad("1"))),
        Contains(Eq("a.xodr:9: road 1 is there twice; give each its own id; links lead to the first")));
}

TEST(RoadErrors, Junctions)
{
    const std::string junction = "<junction id=\"5\" name=\"\"><connection id=\"0\" incomingRoad=\"1\" "
                                 "connectingRoad=\"77\" contactPoint=\"start\"/></junction>\n";
    EXPECT_THAT(
        told(network(plainRoad("1") + junction)),
        Contains(Eq("a.xodr:9: junction 5: connection 0 leads over road 77, which is not there; correct "
                    "connectingRoad")));
    EXPECT_THAT(told(replaced(network(plainRoad("1")), "junction=\"-1\"", "junction=\"6\"")),
                Contains(Eq("a.xodr:3: road 1: its junction 6 is not there; correct the id, or write -1")));
}

TEST(RoadErrors, ControllersAndSignals)
{
    const std::string signals =
        "<signals><signal id=\"s1\" s=\"70\" t=\"0\" type=\"274\" orientation=\"+\"/></signals>";
    EXPECT_THAT(told(network(road("1", 50.0, straightPlan(50.0) + twoLanes() + signals))),
                Contains(Eq("a.xodr:8: road 1: signal s1 is at s 70, not on the road; correct s")));
    EXPECT_THAT(
        told(network(plainRoad("1") +
                     "<controller id=\"c\"><control signalId=\"s9\" type=\"0\"/></controller>\n")),
        Contains(Eq("a.xodr:9: controller c switches signal s9, which is not there; correct signalId")));
}

TEST(RoadErrors, LanesOverEachOther)
{
    EXPECT_THAT(
        told(network(plainRoad("1") + plainRoad("2"))),
        Contains(
            Eq("a.xodr:3: lanes of road 1 lie over lanes of road 2, to which it is not linked; move one, "
               "or join both by a junction")));
}

/// What is not supported is told once, with its count.
TEST(RoadErrors, UnsupportedElementsAreCounted)
{
    const std::string surface = "<surface><CRG file=\"a.crg\"/></surface>\n";
    const auto lines = told(
        network(road("1", 50.0, straightPlan(50.0) + twoLanes() + surface) +
                road("2", 50.0, replaced(straightPlan(50.0), "y=\"0\"", "y=\"90\"") + twoLanes() + surface)));
    EXPECT_THAT(lines,
                testing::ElementsAre("a.xodr:8: surface/CRG is not supported (2 times); it is passed over"));
}

} // namespace
