// SPDX-License-Identifier: Apache-2.0
#include "CourseFile.h"

#include <cstdio>
#include <string>

#include <foundation/WholeFile.h>
#include <pugixml.hpp>

#include "TerrainFile.h"
#include "course/CourseRoad.h"
#include "course/CourseSides.h"
#include "course/XmlFields.h"

namespace islandgen
{

namespace
{

using osgRoads::core::ArcShape;
using osgRoads::core::Clothoid;
using osgRoads::core::Cubic;
using osgRoads::core::CubicProfile;
using osgRoads::core::PlanElement;

constexpr double kMarkWidthM = 0.12;

void writeShape(pugi::xml_node geometry, const PlanElement& element)
{
    if (const auto* arc = std::get_if<ArcShape>(&element.shape()))
        set(geometry.append_child("arc"), "curvature", arc->curvature);
    else if (const auto* spiral = std::get_if<Clothoid>(&element.shape()))
    {
        const pugi::xml_node node = geometry.append_child("spiral");
        set(node, "curvStart", spiral->curvatureAt(0.0));
        set(node, "curvEnd", spiral->curvatureAt(element.length));
    }
    else
        geometry.append_child("line");
}

void writePlan(pugi::xml_node road, const CourseRoad& course)
{
    pugi::xml_node plan = road.append_child("planView");
    for (const PlanElement& element : course.elements)
    {
        const auto start = element.at(0.0);
        pugi::xml_node geometry = plan.append_child("geometry");
        set(geometry, "s", element.s);
        set(geometry, "x", start.position.x);
        set(geometry, "y", start.position.y);
        set(geometry, "hdg", start.headingRad);
        set(geometry, "length", element.length);
        writeShape(geometry, element);
    }
}

void writeProfile(pugi::xml_node parent, const char* name, const CubicProfile& profile)
{
    for (const Cubic& piece : profile.pieces())
    {
        const pugi::xml_node node = parent.append_child(name);
        set(node, "s", piece.s);
        set(node, "a", piece.a);
        set(node, "b", piece.b);
        set(node, "c", piece.c);
        set(node, "d", piece.d);
    }
}

void writeMark(pugi::xml_node lane, double sOffset, const char* type)
{
    const pugi::xml_node mark = lane.append_child("roadMark");
    set(mark, "sOffset", sOffset);
    set(mark, "type", type);
    set(mark, "weight", "standard");
    set(mark, "color", "white");
    set(mark, "width", kMarkWidthM);
    set(mark, "laneChange", std::string(type) == "broken" ? "both" : "none");
}

void writeCentre(pugi::xml_node section, const CourseRoad& course)
{
    pugi::xml_node lane = addLane(section.append_child("center"), 0, "none");
    if (course.noOvertaking.empty() || course.noOvertaking.front().fromM > 0.0)
        writeMark(lane, 0.0, "broken");
    for (const Stretch& stretch : course.noOvertaking)
    {
        writeMark(lane, stretch.fromM, "solid");
        if (stretch.toM < course.lengthM) writeMark(lane, stretch.toM, "broken");
    }
}

void writeLane(pugi::xml_node side, int id, const char* type, double widthM)
{
    pugi::xml_node lane = addLane(side, id, type);
    pugi::xml_node link = lane.append_child("link");
    set(link.append_child("predecessor"), "id", id);
    set(link.append_child("successor"), "id", id);
    writeProfile(lane, "width", CubicProfile({{0.0, widthM, 0.0, 0.0, 0.0}}));
    lane.child("width").attribute("s").set_name("sOffset");
    writeMark(lane, 0.0, id == 1 || id == -1 ? "solid" : "none");
}

void writeLanes(pugi::xml_node road, const CourseRoad& course)
{
    pugi::xml_node section = road.append_child("lanes").append_child("laneSection");
    set(section, "s", 0.0);
    pugi::xml_node left = section.append_child("left");
    writeLane(left, 2, "shoulder", kShoulderM);
    writeLane(left, 1, "driving", kLaneM);
    writeCentre(section, course);
    pugi::xml_node right = section.append_child("right");
    writeLane(right, -1, "driving", kLaneM);
    writeLane(right, -2, "shoulder", kShoulderM);
}

void writeLink(pugi::xml_node parent, const char* name, std::size_t id, const char* contact)
{
    const pugi::xml_node link = parent.append_child(name);
    set(link, "elementType", "road");
    set(link, "elementId", static_cast<int>(id));
    set(link, "contactPoint", contact);
}

void writeRoad(pugi::xml_node root, const CourseRoad& course, std::size_t index, std::size_t count)
{
    pugi::xml_node road = root.append_child("road");
    set(road, "name", ("Course " + std::to_string(index + 1)).c_str());
    set(road, "length", course.lengthM);
    set(road, "id", static_cast<int>(index + 1));
    set(road, "junction", -1);
    set(road, "rule", "RHT");
    pugi::xml_node link = road.append_child("link");
    writeLink(link, "predecessor", (index + count - 1) % count + 1, "end");
    writeLink(link, "successor", (index + 1) % count + 1, "start");
    pugi::xml_node type = road.append_child("type");
    set(type, "s", 0.0);
    set(type, "type", "rural");
    set(type, "country", "DE");
    const pugi::xml_node speed = type.append_child("speed");
    set(speed, "max", kSpeedLimitKmh);
    set(speed, "unit", "km/h");
    writePlan(road, course);
    writeProfile(road.append_child("elevationProfile"), "elevation", course.elevation);
    writeProfile(road.append_child("lateralProfile"), "superelevation", course.superelevationRad);
    writeLanes(road, course);
    writeObjects(road, course);
    writeSignals(road, course);
}

void writeHeader(pugi::xml_node root)
{
    pugi::xml_node header = root.append_child("header");
    set(header, "revMajor", 1);
    set(header, "revMinor", 7);
    set(header, "name", "default course");
    set(header, "vendor", "osgTrainer");
    header.append_child("geoReference")
        .append_child(pugi::node_cdata)
        .set_value("+proj=utm +zone=32 +datum=WGS84 +units=m +no_defs");
    const pugi::xml_node offset = header.append_child("offset");
    set(offset, "x", kCentreEastingM);
    set(offset, "y", kCentreNorthingM);
    set(offset, "z", 0.0);
    set(offset, "hdg", 0.0);
}

} // namespace

foundation::Outcome writeCourse(const Terrain& terrain, const Alignment& alignment,
                                const CourseHeights& heights, const std::filesystem::path& file)
{
    pugi::xml_document document;
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    set(declaration, "version", "1.0");
    set(declaration, "encoding", "UTF-8");
    pugi::xml_node root = document.append_child("OpenDRIVE");
    writeHeader(root);
    const auto roads = roadsOf(terrain, alignment, heights);
    for (std::size_t i = 0; i < roads.size(); ++i)
        writeRoad(root, roads[i], i, roads.size());
    foundation::WholeFile whole(file);
    if (!document.save_file(whole.written().c_str(), "  ")) return whole.failure("cannot be written", "");
    return whole.commit();
}

} // namespace islandgen
