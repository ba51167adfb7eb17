// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include <osgRoads/core/place/PlacedNetwork.h>
#include <osgRoads/core/read/ReadNetwork.h>

/// Small networks for tests, as text.
namespace roadtexts
{

inline constexpr const char* kWidth = R"(<width sOffset="0" a="3.5" b="0" c="0" d="0"/>)";

/// One driving lane of 3.5 m on each side.
inline std::string twoLanes()
{
    return std::string(R"(<lanes><laneSection s="0">
<left><lane id="1" type="driving" level="false">)") +
           kWidth + R"(</lane></left><center><lane id="0" type="none" level="false"/></center>
<right><lane id="-1" type="driving" level="false">)" +
           kWidth + "</lane></right></laneSection></lanes>\n";
}

inline std::string geometry(const std::string& start, double length, const std::string& shape)
{
    return "<geometry " + start + " length=\"" + std::to_string(length) + "\">" + shape + "</geometry>";
}

/// A straight road along x from the origin.
inline std::string straightPlan(double length)
{
    return "<planView>" + geometry(R"(s="0" x="0" y="0" hdg="0")", length, "<line/>") + "</planView>\n";
}

inline std::string road(const std::string& id, double length, const std::string& content,
                        const std::string& attributes = "junction=\"-1\"")
{
    return "<road id=\"" + id + "\" length=\"" + std::to_string(length) + "\" " + attributes + ">\n" +
           content + "</road>\n";
}

inline std::string network(const std::string& content)
{
    return "<OpenDRIVE>\n<header revMajor=\"1\" revMinor=\"7\"/>\n" + content + "</OpenDRIVE>\n";
}

/// Reads a network that must have no problem.
inline osgRoads::core::RoadNetwork sound(const std::string& text)
{
    auto read = osgRoads::core::parseNetwork(text, "test.xodr");
    EXPECT_TRUE(read) << (read ? "" : read.error().message());
    if (!read) return {};
    for (const auto& problem : read->problems)
        ADD_FAILURE() << problem.message("test.xodr");
    return std::move(read->network);
}

inline osgRoads::core::PlacedNetwork placed(const std::string& text)
{
    return osgRoads::core::PlacedNetwork(std::make_shared<const osgRoads::core::RoadNetwork>(sound(text)));
}

/// A bend that climbs and tilts, with a raised sidewalk and lanes that change in number and width.
inline std::string bentRoad(const std::string& start = R"(s="0" x="0" y="0" hdg="0.3")")
{
    const std::string right = std::string(R"(<right><lane id="-1" type="driving" level="false">)") + kWidth +
                              R"(<roadMark sOffset="0" type="broken" width="0.12"/></lane></right>)";
    const std::string centre =
        R"(<center><lane id="0" type="none" level="false"><roadMark sOffset="0" type="solid" width="0.15"/></lane></center>)";
    return network(road(
        "1", 150.0,
        "<planView>" + geometry(start, 150.0, R"(<spiral curvStart="0" curvEnd="0.03"/>)") + "</planView>" +
            R"(<elevationProfile><elevation s="0" a="5" b="0.06" c="-0.0005" d="0"/></elevationProfile>
<lateralProfile><superelevation s="0" a="0" b="0.0005" c="0" d="0"/></lateralProfile>
<lanes><laneSection s="0"><left><lane id="1" type="driving" level="false"><width sOffset="0" a="3.5" b="0" c="0.0002" d="0"/></lane>
<lane id="2" type="sidewalk" level="false"><width sOffset="0" a="2" b="0" c="0" d="0"/><height sOffset="0" inner="0.12" outer="0.15"/></lane></left>)" +
            centre + right +
            R"(</laneSection><laneSection s="70"><left><lane id="1" type="driving" level="false">)" + kWidth +
            "</lane></left>" + centre + right + "</laneSection></lanes>"));
}

} // namespace roadtexts
