// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <gtest/gtest.h>

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

} // namespace roadtexts
