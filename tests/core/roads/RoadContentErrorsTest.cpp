// SPDX-License-Identifier: Apache-2.0
// Typical mistakes in profiles, lanes, marks, objects and signals of OpenDRIVE files, each with the line that
// a person is told.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ToldLines.h"

namespace
{

using namespace roadtexts;
using testing::ElementsAre;

/// A network of one road of 50 m, with more elements behind its lanes: those begin on line 8.
std::string withContent(const std::string& content)
{
    return network(road("1", 50.0, straightPlan(50.0) + twoLanes() + content));
}

/// The same with an elevation or a lateral profile before its lanes, on line 5.
std::string withProfile(const std::string& profile)
{
    return network(road("1", 50.0, straightPlan(50.0) + profile + "\n" + twoLanes()));
}

std::string poleAt(const std::string& attributes, const std::string& content = "")
{
    return withContent("<objects><object id=\"o\" type=\"pole\" zOffset=\"0\" orientation=\"none\" " +
                       attributes + ">" + content + "</object></objects>\n");
}

std::string centreMark(const std::string& mark)
{
    return replaced(network(plainRoad("1")), "<lane id=\"0\" type=\"none\" level=\"false\"/>",
                    "<lane id=\"0\" type=\"none\" level=\"false\">" + mark + "</lane>");
}

TEST(RoadContentErrors, ElevationThatJumps)
{
    const std::string smooth = "<elevationProfile><elevation s=\"0\" a=\"1\" b=\"0.1\" c=\"0\" d=\"0\"/>"
                               "<elevation s=\"20\" a=\"3\" b=\"0\" c=\"0\" d=\"0\"/></elevationProfile>";
    EXPECT_THAT(told(withProfile(smooth)), ElementsAre());
    EXPECT_THAT(told(withProfile(replaced(smooth, "a=\"3\"", "a=\"3.5\""))),
                ElementsAre("a.xodr:3: road 1 at s 20: the elevation jumps by 0.5 m; let its pieces meet"));
}

TEST(RoadContentErrors, WidthThatJumps)
{
    const std::string next = "<width sOffset=\"10\" a=\"2.5\" b=\"0\" c=\"0\" d=\"0\"/>";
    EXPECT_THAT(
        told(replaced(network(plainRoad("1")), kWidth, kWidth + next)),
        ElementsAre("a.xodr:6: road 1 at s 10: the width of lane 1 jumps by 1 m; let its pieces meet"));
    const std::string meets = "<width sOffset=\"10\" a=\"3.5\" b=\"0.1\" c=\"0\" d=\"0\"/>";
    EXPECT_THAT(told(replaced(network(plainRoad("1")), kWidth, kWidth + meets)), ElementsAre());
}

TEST(RoadContentErrors, ElevationsThatDoNotAscend)
{
    EXPECT_THAT(told(withProfile("<elevationProfile><elevation s=\"20\" a=\"0\" b=\"0\" c=\"0\" d=\"0\"/>"
                                 "<elevation s=\"0\" a=\"0\" b=\"0\" c=\"0\" d=\"0\"/></elevationProfile>")),
                ElementsAre("a.xodr:5: road 1: the elevation entries do not ascend; sort them by their "
                            "start"));
}

TEST(RoadContentErrors, CrossfallOfNoSide)
{
    EXPECT_THAT(told(withProfile("<lateralProfile><crossfall side=\"middle\" s=\"0\" a=\"0\" b=\"0\" c=\"0\" "
                                 "d=\"0\"/></lateralProfile>")),
                ElementsAre("a.xodr:5: road 1: crossfall/side has the unknown value \"middle\"; write left, "
                            "right or both, which is used"));
}

TEST(RoadContentErrors, GeometriesThatDoNotAddUp)
{
    const std::string plan = "<planView>" + geometry(R"(s="0" x="0" y="0" hdg="0")", 20.0, "<line/>") +
                             geometry(R"(s="25" x="25" y="0" hdg="0")", 25.0, "<line/>") + "</planView>\n";
    EXPECT_THAT(told(network(road("1", 50.0, plan + twoLanes()))),
                ElementsAre("a.xodr:3: road 1: a geometry ends at s 20, the next begins at 25; correct s or "
                            "length"));
}

TEST(RoadContentErrors, ParameterRangeOfNoKind)
{
    const std::string shape =
        R"(<paramPoly3 pRange="metres" aU="0" bU="50" cU="0" dU="0" aV="0" bV="0" cV="0" dV="0"/>)";
    EXPECT_THAT(told(network(road("1", 50.0,
                                  "<planView>" + geometry(R"(s="0" x="0" y="0" hdg="0")", 50.0, shape) +
                                      "</planView>\n" + twoLanes()))),
                ElementsAre("a.xodr:4: road 1: pRange has the unknown value \"metres\"; write arcLength or "
                            "normalized, which is used"));
}

TEST(RoadContentErrors, LaneWithWidthAndBorder)
{
    EXPECT_THAT(told(replaced(network(plainRoad("1")), kWidth,
                              std::string(kWidth) + R"(<border sOffset="0" a="3" b="0" c="0" d="0"/>)")),
                ElementsAre("a.xodr:6: road 1: lane 1 has width and border; keep one of them; the width is "
                            "used"));
}

TEST(RoadContentErrors, SectionBeyondTheRoad)
{
    const std::string later =
        "<laneSection s=\"70\"><center><lane id=\"0\" type=\"none\"/></center></laneSection></lanes>";
    EXPECT_THAT(told(replaced(network(plainRoad("1")), "</lanes>", later)),
                ElementsAre("a.xodr:7: road 1: a lane section begins at s 70, beyond the road; let it begin "
                            "on the road"));
}

TEST(RoadContentErrors, MarksOfNoKind)
{
    EXPECT_THAT(told(centreMark(R"(<roadMark sOffset="0" type="dotted" color="pink"/>)")),
                ElementsAre("a.xodr:6: road 1: roadMark/type has the unknown value \"dotted\"; use a word of "
                            "the standard",
                            "a.xodr:6: road 1: roadMark/color has the unknown value \"pink\"; use a word of "
                            "the standard"));
    EXPECT_THAT(told(centreMark(R"(<roadMark sOffset="0" type="solid" width="-0.1"/>)")),
                ElementsAre("a.xodr:6: road 1: roadMark/width is negative; write 0 or more; the usual width "
                            "is used"));
    EXPECT_THAT(
        told(centreMark(R"(<roadMark sOffset="0" type="broken"><type name="b" width="0.1">)"
                        R"(<line length="-3" space="6" tOffset="0" sOffset="0"/></type></roadMark>)")),
        ElementsAre("a.xodr:6: road 1: a line of a road mark has a negative length, space or width; "
                    "write 0 or more; 0 is used"));
}

TEST(RoadContentErrors, ObjectsBesideTheRoadsEndOrWithoutSize)
{
    EXPECT_THAT(told(poleAt("s=\"-3\" t=\"5\"")),
                ElementsAre("a.xodr:8: road 1: object o is at s -3, not on the road; correct s"));
    EXPECT_THAT(told(poleAt("s=\"3\" t=\"5\" radius=\"-1\"")),
                ElementsAre("a.xodr:8: road 1: object o has a negative size; write 0 or more; 0 is used"));
    EXPECT_THAT(told(poleAt("s=\"3\" t=\"5\" dynamic=\"perhaps\"")),
                ElementsAre("a.xodr:8: road 1: object/dynamic has the unknown value \"perhaps\"; use a word "
                            "of the standard"));
    EXPECT_THAT(
        told(poleAt("s=\"3\" t=\"5\"", R"(<repeat s="0" length="20" distance="-2" tStart="5" tEnd="5"/>)")),
        ElementsAre("a.xodr:8: road 1: repeat has a negative length or distance; write 0 or more; 0 "
                    "is used"));
}

TEST(RoadContentErrors, StructuresBesideTheRoad)
{
    EXPECT_THAT(
        told(withContent("<objects><tunnel id=\"t\" s=\"60\" length=\"20\" type=\"standard\"/></objects>\n")),
        ElementsAre("a.xodr:8: road 1: tunnel t is at s 60, not on the road; correct s"));
    EXPECT_THAT(told(withContent(
                    "<objects><bridge id=\"b\" s=\"10\" length=\"-20\" type=\"concrete\"/></objects>\n")),
                ElementsAre("a.xodr:8: road 1: bridge b is -20 m long; write a length above 0; it is not "
                            "drawn"));
}

TEST(RoadContentErrors, SignalsWithoutIdOrDirection)
{
    EXPECT_THAT(
        told(withContent("<signals><signal s=\"5\" t=\"4\" type=\"274\" orientation=\"up\"/>"
                         "</signals>\n")),
        ElementsAre("a.xodr:8: road 1: signal has no attribute id; add it",
                    "a.xodr:8: road 1: orientation has the unknown value \"up\"; write +, - or none"));
    EXPECT_THAT(told(withContent("<signals><signalReference id=\"s9\" s=\"5\" t=\"4\" orientation=\"+\"/>"
                                 "</signals>\n")),
                ElementsAre("a.xodr:8: road 1: signal s9 is not there; correct the id of signalReference"));
}

TEST(RoadContentErrors, SpeedOfNoUnit)
{
    EXPECT_THAT(
        told(withProfile("<type s=\"0\" type=\"town\"><speed max=\"50\" unit=\"knots\"/></type>")),
        ElementsAre("a.xodr:5: road 1: speed/unit has the unknown value \"knots\"; write m/s, km/h or "
                    "mph; m/s is used"));
}

TEST(RoadContentErrors, NoHeaderOrOneOfAnotherVersion)
{
    const std::string header = "<header revMajor=\"1\" revMinor=\"7\"/>";
    EXPECT_THAT(told(replaced(network(plainRoad("1")), header, "")),
                ElementsAre("a.xodr:1: there is no header; add one; version 1.4 is assumed"));
    EXPECT_THAT(told(replaced(network(plainRoad("1")), "revMinor=\"7\"", "revMinor=\"9\"")),
                ElementsAre("a.xodr:2: version 1.9 of OpenDRIVE; 1.4 to 1.8 are understood; what differs is "
                            "told"));
}

/// A text that is no text at all is told without a line: it has none.
TEST(RoadContentErrors, FilesThatHoldNoText)
{
    const auto messageOf = [](const std::string& bytes)
    {
        const auto read = osgRoads::core::parseNetwork(bytes, "a.xodr");
        return read ? "" : read.error().message();
    };
    EXPECT_EQ(messageOf(""), "a.xodr: there is nothing in the file; write it again, or name another one");
    EXPECT_EQ(messageOf(" \n\n"),
              "a.xodr: there is nothing in the file; write it again, or name another one");
    EXPECT_EQ(messageOf("\x1F\x8B\b"), "a.xodr: compressed by gzip; unpack the file with gunzip");
    EXPECT_EQ(messageOf("\xFF\xFE<"), "a.xodr:1: not valid UTF-16; save the file as UTF-8");
}

TEST(RoadContentErrors, MarkingsOfObjects)
{
    const auto marked = [](const std::string& attributes, const std::string& corners = "")
    {
        return told(poleAt(
            "s=\"10\" t=\"3\" length=\"2\" width=\"1\"",
            "<markings><marking color=\"white\" lineLength=\"0\" spaceLength=\"0\" startOffset=\"0\" " +
                attributes + ">" + corners + "</marking></markings>"));
    };
    EXPECT_THAT(marked("stopOffset=\"0\" side=\"left\""), ElementsAre());
    EXPECT_THAT(
        marked("stopOffset=\"0\" side=\"top\""),
        ElementsAre("a.xodr:8: road 1: marking/side has the unknown value \"top\"; use a word of the "
                    "standard",
                    "a.xodr:8: road 1: a marking of object o has neither a side nor two corners; write side "
                    "or cornerReference; it is not painted"));
    EXPECT_THAT(
        marked("stopOffset=\"-1\" side=\"left\""),
        ElementsAre("a.xodr:8: road 1: a marking of object o has a negative width, length or offset; write 0 "
                    "or more; 0 is used"));
    EXPECT_THAT(
        marked("stopOffset=\"0\" side=\"left\"", "<cornerReference id=\"4\"/>"),
        ElementsAre("a.xodr:8: road 1: a marking of object o names corner 4, which none of its outlines has; "
                    "give a corner that id; this one is passed over"));
}

} // namespace
