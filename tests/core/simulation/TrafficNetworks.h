// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "../roads/RoadTexts.h"
#include "simulation/road/JunctionTable.h"

/// Networks on which traffic never comes to an end: four arms, of which two and two are joined by loops,
/// around a crossing or a roundabout. Units: metres.
namespace simulation::trafficnetworks
{

inline constexpr double kHalfM = 15.0, kArmM = 100.0; ///< of the crossing, of an arm

inline std::string link(const std::string& name, const std::string& type, int id,
                        const std::string& contact = "")
{
    return "<" + name + " elementType=\"" + type + "\" elementId=\"" + std::to_string(id) + "\"" +
           (contact.empty() ? "" : " contactPoint=\"" + contact + "\"") + "/>";
}

inline std::string number(double value)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.12g", value);
    return text;
}

inline std::string plan(const glm::dvec2& from, double headingRad, double lengthM, double curvature)
{
    const std::string shape = curvature == 0.0 ? "<line/>" : "<arc curvature=\"" + number(curvature) + "\"/>";
    return "<planView><geometry s=\"0\" x=\"" + number(from.x) + "\" y=\"" + number(from.y) + "\" hdg=\"" +
           number(headingRad) + "\" length=\"" + number(lengthM) + "\">" + shape + "</geometry></planView>";
}

inline glm::dvec2 towards(int arm)
{
    const double angle = 0.5 * std::numbers::pi * arm;
    return {std::cos(angle), std::sin(angle)};
}

/// A lane of one side: -1 on the right. The lanes before and behind it, where its road has others.
inline std::string laneText(int id, const std::string& links = "")
{
    return "<lane id=\"" + std::to_string(id) + "\" type=\"driving\" level=\"false\">" +
           (links.empty() ? "" : "<link>" + links + "</link>") + roadtexts::kWidth + "</lane>";
}

inline std::string lanesText(const std::string& left, const std::string& right)
{
    return "<lanes><laneSection s=\"0\">" + (left.empty() ? "" : "<left>" + left + "</left>") +
           "<center><lane id=\"0\" type=\"none\" level=\"false\"/></center><right>" + right +
           "</right></laneSection></lanes>";
}

inline std::string roadText(int id, double lengthM, const std::string& links, const std::string& rest,
                            int junction)
{
    return "<road id=\"" + std::to_string(id) + "\" length=\"" + number(lengthM) + "\" junction=\"" +
           std::to_string(junction) + "\"><link>" + links + "</link>" + rest + "</road>\n";
}

inline const std::string kTownLimit = R"(<type s="0" type="town"><speed max="50" unit="km/h"/></type>)";

/// What stands on the arms to the east, north, west and south, as elements of their signals.
using ArmSigns = std::array<std::string, 4>;

/// Arms 1 to 4 to the east, north, west and south, that begin so far from the origin; loops 5 and 6. The arms
/// begin at junction 100, or each at one of its own, from 100 on.
inline std::string armsText(double fromM, bool haveOwnJunctions, const ArmSigns& signs = {})
{
    std::string text;
    const double pi = std::numbers::pi, loopM = 1.5 * pi * (fromM + kArmM);
    for (int arm = 0; arm < 4; ++arm)
    {
        const int loop = arm < 2 ? 5 : 6;
        const std::string& own = signs[static_cast<std::size_t>(arm)];
        const bool entersLoop = arm % 2 == 0; // east and west; the others are its ends
        const std::string ahead = std::string("<successor id=\"") + (entersLoop ? "-1" : "1") + "\"/>";
        const std::string back = std::string("<successor id=\"") + (entersLoop ? "1" : "-1") + "\"/>";
        text += roadText(arm + 1, kArmM,
                         link("predecessor", "junction", 100 + (haveOwnJunctions ? arm : 0)) +
                             link("successor", "road", loop, entersLoop ? "start" : "end"),
                         kTownLimit + plan(fromM * towards(arm), 0.5 * pi * arm, kArmM, 0.0) +
                             lanesText(laneText(1, back), laneText(-1, ahead)) +
                             (own.empty() ? "" : "<signals>" + own + "</signals>"),
                         -1);
    }
    for (int loop = 0; loop < 2; ++loop)
    {
        const int from = 2 * loop, to = from + 1;
        text += roadText(
            5 + loop, loopM,
            link("predecessor", "road", from + 1, "end") + link("successor", "road", to + 1, "end"),
            kTownLimit +
                plan((fromM + kArmM) * towards(from), 0.5 * pi * from, loopM, 1.0 / (fromM + kArmM)) +
                lanesText(laneText(1, R"(<predecessor id="1"/><successor id="-1"/>)"),
                          laneText(-1, R"(<predecessor id="-1"/><successor id="1"/>)")),
            -1);
    }
    return text;
}

inline std::string connectionText(int incoming, int connecting, int lane)
{
    return "<connection id=\"" + std::to_string(connecting) + "\" incomingRoad=\"" +
           std::to_string(incoming) + "\" connectingRoad=\"" + std::to_string(connecting) +
           "\" contactPoint=\"start\"><laneLink from=\"" + std::to_string(lane) +
           "\" to=\"-1\"/></connection>";
}

/// The connecting roads are those from 11 on.
inline std::string crossingText(const ArmSigns& signs = {}, const std::string& priorities = "")
{
    const double pi = std::numbers::pi;
    std::string text = armsText(kHalfM, false, signs), connections;
    int id = 11;
    for (int from = 0; from < 4; ++from)
        for (int turn = 1; turn < 4; ++turn, ++id)
        {
            const int to = (from + turn) % 4; // 1: to the right, 2: straight on, 3: to the left
            const double curvature = turn == 2 ? 0.0 : turn == 1 ? -1.0 / kHalfM : 1.0 / kHalfM;
            const double lengthM = turn == 2 ? 2.0 * kHalfM : 0.5 * pi * kHalfM;
            text += roadText(
                id, lengthM,
                link("predecessor", "road", from + 1, "start") + link("successor", "road", to + 1, "start"),
                kTownLimit + plan(kHalfM * towards(from), 0.5 * pi * from + pi, lengthM, curvature) +
                    lanesText("", laneText(-1, R"(<predecessor id="1"/><successor id="-1"/>)")),
                100);
            connections += connectionText(from + 1, id, 1);
        }
    return roadtexts::network(text + "<junction id=\"100\" name=\"\">" + connections + priorities +
                              "</junction>");
}

/// A cubic curve between two places with headings.
struct CurveText
{
    std::string plan;
    double lengthM = 0.0;
};

inline CurveText curve(const glm::dvec2& from, double headingRad, const glm::dvec2& to, double endHeadingRad)
{
    const glm::dvec2 ahead(std::cos(headingRad), std::sin(headingRad)), left(-ahead.y, ahead.x);
    const glm::dvec2 apart = to - from, end(glm::dot(apart, ahead), glm::dot(apart, left));
    const double pull = glm::length(apart), turn = endHeadingRad - headingRad;
    const glm::dvec2 b(pull, 0.0), last = pull * glm::dvec2(std::cos(turn), std::sin(turn));
    const glm::dvec2 c = 3.0 * end - 2.0 * b - last, d = b + last - 2.0 * end;
    CurveText made;
    constexpr int kParts = 2000;
    for (int i = 0; i < kParts; ++i)
    {
        const double p = (i + 0.5) / kParts;
        made.lengthM += glm::length(b + 2.0 * p * c + 3.0 * p * p * d) / kParts;
    }
    made.plan = "<planView><geometry s=\"0\" x=\"" + number(from.x) + "\" y=\"" + number(from.y) +
                "\" hdg=\"" + number(headingRad) + "\" length=\"" + number(made.lengthM) +
                "\"><paramPoly3 pRange=\"normalized\" aU=\"0\" bU=\"" + number(b.x) + "\" cU=\"" +
                number(c.x) + "\" dU=\"" + number(d.x) + "\" aV=\"0\" bV=\"" + number(b.y) + "\" cV=\"" +
                number(c.y) + "\" dV=\"" + number(d.y) + "\"/></geometry></planView>";
    return made;
}

/// A ring of 40 m with four arms: one-way arcs 21 to 24 between the junctions 100 to 103; through those the
/// ring's roads 31 to 34, the ways in 41 to 44 and out 51 to 54.
inline std::string roundaboutText()
{
    constexpr double kRadiusM = 20.0, kGapRad = 0.5, kArmFromM = 44.0;
    const double quarter = 0.5 * std::numbers::pi;
    const auto at = [](double angle) { return kRadiusM * glm::dvec2(std::cos(angle), std::sin(angle)); };
    const std::string one = lanesText("", laneText(-1, R"(<predecessor id="-1"/><successor id="-1"/>)"));
    const std::string enters = lanesText("", laneText(-1, R"(<predecessor id="1"/><successor id="-1"/>)"));
    std::string text = armsText(kArmFromM, true), junctions;
    for (int i = 0; i < 4; ++i)
    {
        const int arc = 21 + i, before = 21 + (i + 3) % 4, arm = i + 1, junction = 100 + i;
        const double middle = quarter * i, out = middle - kGapRad, in = middle + kGapRad;
        const double arcM = kRadiusM * (quarter - 2.0 * kGapRad), gapM = kRadiusM * 2.0 * kGapRad;
        text += roadText(
            arc, arcM,
            link("predecessor", "junction", junction) + link("successor", "junction", 100 + (i + 1) % 4),
            kTownLimit + plan(at(in), in + quarter, arcM, 1.0 / kRadiusM) + lanesText("", laneText(-1)), -1);
        text += roadText(31 + i, gapM,
                         link("predecessor", "road", before, "end") + link("successor", "road", arc, "start"),
                         kTownLimit + plan(at(out), out + quarter, gapM, 1.0 / kRadiusM) + one, junction);
        const CurveText entry = curve(kArmFromM * towards(i), middle + 2.0 * quarter, at(in), in + quarter);
        text += roadText(41 + i, entry.lengthM,
                         link("predecessor", "road", arm, "start") + link("successor", "road", arc, "start"),
                         kTownLimit + entry.plan + enters, junction);
        const CurveText exit = curve(at(out), out + quarter, kArmFromM * towards(i), middle);
        text += roadText(51 + i, exit.lengthM,
                         link("predecessor", "road", before, "end") + link("successor", "road", arm, "start"),
                         kTownLimit + exit.plan + one, junction);
        junctions += "<junction id=\"" + std::to_string(junction) + "\" name=\"\">" +
                     connectionText(before, 31 + i, -1) + connectionText(before, 51 + i, -1) +
                     connectionText(arm, 41 + i, 1) + "</junction>";
    }
    return roadtexts::network(text + junctions);
}

/// A light on each arm, 2 m before the crossing: 201 to 204.
inline ArmSigns lightsOnArms()
{
    ArmSigns lights;
    for (std::size_t arm = 0; arm < lights.size(); ++arm)
        lights[arm] =
            "<signal s=\"2\" t=\"5\" id=\"" + std::to_string(201 + arm) +
            R"(" name="" dynamic="yes" orientation="-" country="OpenDRIVE" type="1000001" subtype="-1" zOffset="3" value="-1" height="0.8" width="0.4"/>)";
    return lights;
}

inline std::shared_ptr<const RoadScene> crossing(const std::string& text = crossingText())
{
    return std::make_shared<const RoadScene>(roadtexts::sound(text));
}

/// The lane through the crossing from an arm to another one: 0 to 3, east, north, west, south.
inline JunctionLane through(const RoadScene& roads, int from, int to)
{
    const int turn = (to - from + 4) % 4;
    return {roads.network().roadIndex(std::to_string(11 + 3 * from + turn - 1)), -1, true};
}

} // namespace simulation::trafficnetworks
