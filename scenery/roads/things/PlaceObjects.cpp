// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 13 (objects).
#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>

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

using models::RoadModel;
using osgRoads::core::ObjectInstance;
using osgRoads::core::PlacedNetwork;
using osgRoads::core::RoadObject;

constexpr double kVergeM =
    2.5; ///< beside the lanes things stand at the height of the road, further away on the ground

std::string wordsOf(const RoadObject& object)
{
    std::string words = object.type + " " + object.subtype + " " + object.name;
    std::transform(words.begin(), words.end(), words.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return words;
}

bool has(const std::string& words, std::string_view part)
{
    return words.find(part) != std::string::npos;
}

bool isPlant(const std::string& words)
{
    return has(words, "vegetation") || has(words, "tree") || has(words, "bush") || has(words, "hedge");
}

RoadModel modelOf(const RoadObject& object, const ObjectInstance& instance, bool& isKnown)
{
    const std::string words = wordsOf(object);
    RoadModel model;
    model.heightM = instance.height;
    isKnown = true;
    if (has(words, "guide") || has(words, "delineator"))
        model.kind = RoadModel::Kind::delineator;
    else if (has(words, "lamp") || has(words, "streetlight"))
        model.kind = RoadModel::Kind::lampPost;
    else if (has(words, "cone"))
        model.kind = RoadModel::Kind::cone;
    else if (has(words, "pole"))
    {
        model.kind = RoadModel::Kind::pole;
        model.widthM = instance.radius > 0.0 ? 2.0 * instance.radius : instance.width;
    }
    else
    {
        isKnown = has(words, "building") || has(words, "barrier") || has(words, "obstacle");
        model.lengthM = instance.radius > 0.0 ? 2.0 * instance.radius : instance.length;
        model.widthM = instance.radius > 0.0 ? 2.0 * instance.radius : instance.width;
    }
    return model;
}

glm::dvec3 standsAt(const PlacedNetwork& placed, int road, const ObjectInstance& instance,
                    const GroundHeight& ground)
{
    glm::dvec3 at = placed.surfacePoint(road, instance.s, instance.t);
    const auto extent = osgRoads::core::extentAt(placed.road(road), instance.s);
    const bool isFar = instance.t > extent.leftT + kVergeM || instance.t < extent.rightT - kVergeM;
    if (ground && isFar)
        if (const auto height = ground(at.x, at.y)) at.z = *height;
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
              const GroundHeight& ground, RoadThings& into)
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
        thing.model = models::makeOutlineBuilding(std::move(corners), std::move(heights));
        if (!thing.model.mesh.faces.empty()) into.own.push_back(std::move(thing));
        return true;
    }
    return false;
}

} // namespace

void placeObjects(const PlacedNetwork& placed, int road, const GroundHeight& ground, RoadThings& into)
{
    for (const RoadObject& object : placed.road(road).objects)
    {
        const std::string words = wordsOf(object),
                          kind = "object " + (object.type.empty() ? std::string("?") : object.type);
        if (osgRoads::core::paintKind(object)) continue;
        if (addOutline(placed, road, object, into))
        {
            ++into.withModel[kind];
            continue;
        }
        for (const ObjectInstance& instance : osgRoads::core::objectInstances(object))
        {
            bool isKnown = true;
            const RoadModel model = modelOf(object, instance, isKnown);
            ++(isKnown || isPlant(words) || instance.isStretch ? into.withModel : into.withoutModel)[kind];
            if (instance.isStretch)
            {
                if (isPlant(words))
                    addHedge(placed, road, instance, ground, into);
                else
                    placeStretch(placed, road, object, instance, into);
                continue;
            }
            StandingThing thing;
            thing.position = standsAt(placed, road, instance, ground);
            thing.axes = uprightAxes(placed, road, instance.s, instance.t, instance.headingRad);
            if (isPlant(words))
                addPlant(into, thing, instance.height);
            else
                addStanding(into, model, thing);
        }
    }
}

} // namespace scenery::roads
