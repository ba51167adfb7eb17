// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 13 (objects).
#include <algorithm>
#include <cmath>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/PaintedItem.h>
#include <osgRoads/core/query/RoadSurface.h>

#include "scenery/models/roads/RoadBuilding.h"
#include "scenery/roads/things/Placers.h"
#include "scenery/roads/things/ThingPose.h"

namespace scenery::roads
{

namespace
{

using osgRoads::core::ObjectInstance;
using osgRoads::core::PlacedNetwork;
using osgRoads::core::RoadObject;

constexpr double kVergeM =
    2.5; ///< beside the lanes things stand at the height of the road, further away on the ground

glm::dvec3 standsAt(const PlacedNetwork& placed, int road, const ObjectInstance& instance,
                    const foundation::HeightInPlan& ground)
{
    glm::dvec3 at = placed.surfacePoint(road, instance.s, instance.t);
    const auto extent = osgRoads::core::extentAt(placed.road(road), instance.s);
    const bool isFar = instance.t > extent.leftT + kVergeM || instance.t < extent.rightT - kVergeM;
    if (ground && isFar)
        if (const auto height = ground(glm::dvec2(at))) at.z = *height;
    at.z += instance.z;
    return at;
}

void addPlant(RoadThings& into, const StandingThing& thing, double heightM)
{
    const bool isTree = heightM > 4.5;
    GrownModel grown{isTree ? models::Kind::oak : models::Kind::bush, 1 + into.plants.size() % 2};
    const auto found = std::find(into.grown.begin(), into.grown.end(), grown);
    StandingThing plant = thing;
    plant.model = static_cast<std::size_t>(found - into.grown.begin());
    const auto& facts = models::factsOf(grown.kind);
    plant.scale = std::clamp(
        (heightM > 0.0 ? heightM : 3.0) / (0.5 * (facts.leastHeightM + facts.mostHeightM)), 0.2, 3.0);
    if (found == into.grown.end()) into.grown.push_back(grown);
    into.plants.push_back(plant);
}

/// Adds plants from the start to the end of a stretch, about as far from each other as they are high.
void addHedge(const PlacedNetwork& placed, int road, const ObjectInstance& stretch,
              const foundation::HeightInPlan& ground, RoadThings& into)
{
    const double height = stretch.height > 0.0 ? stretch.height : 1.5, length = stretch.sEnd - stretch.s;
    const int plants = std::clamp(static_cast<int>(length / (0.6 * height)), 1, 2000);
    for (int i = 0; i <= plants; ++i)
    {
        const double share = static_cast<double>(i) / plants;
        ObjectInstance one = stretch;
        one.s += length * share;
        one.t += (stretch.tEnd - stretch.t) * share;
        StandingThing thing;
        thing.position = standsAt(placed, road, one, ground);
        thing.axes = uprightAxes(placed, road, one.s, one.t, 2.4 * i);
        addPlant(into, thing, height);
    }
}

constexpr double kBodyWallM = 0.3, kLeastBodyM = 0.3; ///< lower outlines are driven over

void addWall(const glm::dvec3& from, const glm::dvec3& to, double heightM, RoadThings& into)
{
    if (heightM < kLeastBodyM) return;
    simulation::Obstacle wall = simulation::pieceBetween(simulation::ObstacleKind::house, glm::dvec2(from),
                                                         glm::dvec2(to), kBodyWallM);
    wall.lowM = std::min(from.z, to.z) - 1.0;
    wall.highM = std::max(from.z, to.z) + heightM;
    into.bodies.add(wall, "building");
}

/// Adds a building by its outer outline. Returns false when it has none.
bool addOutline(const PlacedNetwork& placed, int road, const RoadObject& object, RoadThings& into)
{
    for (const auto& outline : object.outlines)
    {
        if (!outline.isOuter || outline.corners.size() < 3) continue;
        OwnThing thing;
        const auto inertial = osgRoads::core::outlineCorners(placed.road(road), object, outline);
        const glm::dvec3 shift = placed.surfacePoint(road, object.s, object.t) -
                                 osgRoads::core::surfacePoint(placed.road(road), object.s, object.t);
        std::vector<double> heights;
        std::vector<glm::dvec3> corners;
        thing.origin = inertial.front() + shift;
        for (std::size_t i = 0; i < inertial.size(); ++i)
        {
            corners.push_back(inertial[i] - inertial.front());
            heights.push_back(
                std::max(outline.corners[i].height > 0.0 ? outline.corners[i].height : object.height, 0.1));
        }
        for (std::size_t i = 0; i < corners.size(); ++i)
            addWall(thing.origin + corners[i], thing.origin + corners[(i + 1) % corners.size()],
                    std::max(heights[i], heights[(i + 1) % corners.size()]), into);
        thing.model = models::makeOutlineBuilding(std::move(corners), std::move(heights));
        if (!thing.model.mesh.faces.empty()) into.own.push_back(std::move(thing));
        return true;
    }
    return false;
}

/// A building of the size that is told, 1 m into the ground.
void addBuilding(const PlacedNetwork& placed, int road, const ObjectInstance& instance,
                 const foundation::HeightInPlan& ground, RoadThings& into)
{
    OwnThing thing;
    thing.origin = standsAt(placed, road, instance, ground);
    const glm::dmat3 axes = uprightAxes(placed, road, instance.s, instance.t, instance.headingRad);
    const double u = 0.5 * instance.length, v = 0.5 * instance.width;
    std::vector<glm::dvec3> corners{axes * glm::dvec3(-u, -v, 0.0), axes * glm::dvec3(u, -v, 0.0),
                                    axes * glm::dvec3(u, v, 0.0), axes * glm::dvec3(-u, v, 0.0)};
    for (std::size_t i = 0; i < corners.size(); ++i)
        addWall(thing.origin + corners[i], thing.origin + corners[(i + 1) % 4], instance.height, into);
    thing.model = models::makeOutlineBuilding(std::move(corners), std::vector<double>(4, instance.height));
    into.own.push_back(std::move(thing));
}

/// A barrier that the file has as one body lies along the road, where it is turned by less than this.
constexpr double kAlongRad = 0.2;

ObjectInstance asStretch(const ObjectInstance& instance)
{
    ObjectInstance stretch = instance;
    stretch.isStretch = true;
    stretch.s = instance.s - 0.5 * instance.length;
    stretch.sEnd = instance.s + 0.5 * instance.length;
    stretch.tEnd = instance.t;
    stretch.zEnd = instance.z;
    stretch.widthEnd = instance.width;
    stretch.heightEnd = instance.height;
    return stretch;
}

bool isBarrier(const ObjectWords& words)
{
    return words.any({"barrier", "railing", "guardrail", "soundbarrier", "fence"});
}

void placeInstance(const PlacedNetwork& placed, int road, const ObjectWords& words,
                   const ObjectInstance& instance, const foundation::HeightInPlan& ground, RoadThings& into)
{
    if (instance.isStretch && isPlant(words)) return addHedge(placed, road, instance, ground, into);
    const auto formOf = [&](const ObjectInstance& stretch)
    {
        return stretchForm(words, std::max(stretch.width, stretch.widthEnd),
                           std::max(stretch.height, stretch.heightEnd));
    };
    if (instance.isStretch) return placeStretch(placed, road, formOf(instance), instance, into);
    if (isBarrier(words) && instance.length > 0.0 && std::fabs(std::sin(instance.headingRad)) < kAlongRad)
    {
        const ObjectInstance stretch = asStretch(instance);
        return placeStretch(placed, road, formOf(stretch), stretch, into);
    }
    const bool hasSize = instance.length > 0.0 && instance.width > 0.0 && instance.height > 0.0;
    if (words.any({"building", "house"}) && hasSize) return addBuilding(placed, road, instance, ground, into);
    StandingThing thing;
    thing.position = standsAt(placed, road, instance, ground);
    thing.axes = uprightAxes(placed, road, instance.s, instance.t, instance.headingRad);
    if (isPlant(words)) return addPlant(into, thing, instance.height);
    thing.axes = tiltedAxes(thing.axes, instance.pitchRad, instance.rollRad);
    addStanding(into, objectModel(words, instance).value_or(boxOf(instance)), thing);
}

} // namespace

void placeObjects(const PlacedNetwork& placed, int road, const foundation::HeightInPlan& ground,
                  RoadThings& into)
{
    for (const RoadObject& object : placed.road(road).objects)
    {
        if (osgRoads::core::paintKind(object) || addOutline(placed, road, object, into)) continue;
        const ObjectWords words(object);
        for (const ObjectInstance& instance : osgRoads::core::objectInstances(object))
            placeInstance(placed, road, words, instance, ground, into);
    }
}

} // namespace scenery::roads
