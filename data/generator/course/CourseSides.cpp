// SPDX-License-Identifier: Apache-2.0
#include "CourseSides.h"

#include <string>
#include <vector>

#include "course/XmlFields.h"

namespace islandgen
{

namespace
{

constexpr double kEdgeM = kLaneM + kShoulderM;
constexpr double kPostBesideM = kEdgeM + 0.5, kRailBesideM = kEdgeM + 0.75, kSignBesideM = kEdgeM + 1.2;
constexpr double kPostSpacingM = 50.0, kPostFromPortalM = 5.0;
constexpr double kTightRadiusM = 180.0, kWarningM = 90.0, kLimitSignM = 30.0;

/// What stands along a road; `distanceM` 0: without a break.
struct Row
{
    const char *type, *name;
    Stretch stretch;
    double distanceM, t, heightM, widthM;
};

void writeRow(pugi::xml_node objects, int id, const Row& row)
{
    pugi::xml_node object = objects.append_child("object");
    set(object, "type", row.type);
    set(object, "name", row.name);
    set(object, "id", id);
    set(object, "s", row.stretch.fromM);
    set(object, "t", row.t);
    set(object, "zOffset", 0.0);
    set(object, "orientation", "none");
    set(object, "height", row.heightM);
    set(object, "width", row.widthM);
    set(object, "length", row.widthM);
    const pugi::xml_node repeat = object.append_child("repeat");
    set(repeat, "s", row.stretch.fromM);
    set(repeat, "length", row.stretch.toM - row.stretch.fromM);
    set(repeat, "distance", row.distanceM);
    for (const char* name : {"tStart", "tEnd"})
        set(repeat, name, row.t);
    for (const char* name : {"heightStart", "heightEnd"})
        set(repeat, name, row.heightM);
    for (const char* name : {"widthStart", "widthEnd"})
        set(repeat, name, row.widthM);
    for (const char* name : {"zOffsetStart", "zOffsetEnd"})
        set(repeat, name, 0.0);
}

/// A sign: its German number, and on which side it stands for whom.
struct Sign
{
    double s;
    bool isForward;
    const char *type, *subtype;
    int value;
};

void writeSign(pugi::xml_node signs, int id, const Sign& sign)
{
    pugi::xml_node signal = signs.append_child("signal");
    set(signal, "s", sign.s);
    set(signal, "t", sign.isForward ? -kSignBesideM : kSignBesideM);
    set(signal, "id", id);
    set(signal, "name", "");
    set(signal, "dynamic", "no");
    set(signal, "orientation", sign.isForward ? "+" : "-");
    set(signal, "zOffset", 2.0);
    set(signal, "country", "DE");
    set(signal, "type", sign.type);
    set(signal, "subtype", sign.subtype);
    if (sign.value > 0)
    {
        set(signal, "value", sign.value);
        set(signal, "unit", "km/h");
    }
    set(signal, "height", 0.6);
    set(signal, "width", 0.6);
}

void writeTunnel(pugi::xml_node objects, int id, const Stretch& stretch)
{
    pugi::xml_node tunnel = objects.append_child("tunnel");
    set(tunnel, "s", stretch.fromM);
    set(tunnel, "length", stretch.toM - stretch.fromM);
    set(tunnel, "id", id);
    set(tunnel, "name", "");
    set(tunnel, "type", "standard");
    set(tunnel, "lighting", 0.5);
    set(tunnel, "daylight", 0.3);
}

/// The parts of a road on which posts stand: before, between and behind its tunnels.
std::vector<Stretch> openPartsOf(const CourseRoad& course)
{
    std::vector<Stretch> parts;
    Stretch part{0.5 * kPostSpacingM, 0.0};
    for (const Stretch& tunnel : course.tunnels)
    {
        part.toM = tunnel.fromM - kPostFromPortalM;
        if (part.toM > part.fromM) parts.push_back(part);
        part.fromM = tunnel.toM + kPostFromPortalM;
    }
    part.toM = course.lengthM - 0.5 * kPostSpacingM;
    parts.push_back(part);
    return parts;
}

} // namespace

void writeObjects(pugi::xml_node road, const CourseRoad& course)
{
    pugi::xml_node objects = road.append_child("objects");
    int id = 1;
    for (const double side : {1.0, -1.0})
    {
        for (const Stretch& open : openPartsOf(course))
            writeRow(objects, id++,
                     {"pole", "delineator", open, kPostSpacingM, side * kPostBesideM, 1.0, 0.12});
        for (const Stretch& rail : side > 0.0 ? course.leftRail : course.rightRail)
            writeRow(objects, id++, {"barrier", "guardRail", rail, 0.0, side * kRailBesideM, 0.75, 0.3});
    }
    for (const Stretch& tunnel : course.tunnels)
        writeTunnel(objects, id++, tunnel);
}

void writeSignals(pugi::xml_node road, const CourseRoad& course)
{
    pugi::xml_node signs = road.append_child("signals");
    int id = 1;
    writeSign(signs, id++, {kLimitSignM, true, "274", "-1", kSpeedLimitKmh});
    writeSign(signs, id++, {course.lengthM - kLimitSignM, false, "274", "-1", kSpeedLimitKmh});
    for (const Bend& bend : course.bends)
    {
        if (bend.radiusM > kTightRadiusM) continue;
        if (const double s = bend.startM - kWarningM; s > 0.0)
            writeSign(signs, id++, {s, true, "103", bend.isLeft ? "10" : "20", 0});
        if (const double s = bend.endM + kWarningM; s < course.lengthM)
            writeSign(signs, id++, {s, false, "103", bend.isLeft ? "20" : "10", 0});
    }
}

} // namespace islandgen
