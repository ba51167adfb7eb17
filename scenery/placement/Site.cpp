// SPDX-License-Identifier: Apache-2.0
#include "scenery/placement/Site.h"

#include <algorithm>
#include <cmath>

#include <foundation/Fnv1a.h>

#include "scenery/placement/Footing.h"
#include "scenery/placement/Patches.h"

namespace scenery
{

namespace
{

constexpr double kLowShoreM = 0.5; ///< above the sea, or waves wash it away
constexpr double kPathStepM = 10.0;

std::uint64_t seedOf(std::uint64_t seed, const std::string& name)
{
    foundation::Fnv1a hash(seed);
    hash.add(name);
    return hash.value();
}

double longestReachM(const SceneryDescription& description)
{
    double most = 1.0;
    for (const SceneryField& field : description.fields)
        if (field.where.pathDistanceM && field.where.pathDistanceM->most < 1e7)
            most = std::max(most, field.where.pathDistanceM->most + 1.0);
    return most;
}

bool isInPolygon(const std::vector<glm::dvec2>& polygon, glm::dvec2 place)
{
    bool isInside = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
    {
        const glm::dvec2 &a = polygon[i], &b = polygon[j];
        if ((a.y > place.y) != (b.y > place.y) && place.x < (b.x - a.x) * (place.y - a.y) / (b.y - a.y) + a.x)
            isInside = !isInside;
    }
    return isInside;
}

} // namespace

Site::Site(const SceneryDescription& description, std::span<const Measures> measures, const Ground& ground,
           const Ways& ways)
    : _description(description),
      _measures(measures),
      _ground(ground),
      _objects(objectsOf(description)),
      _clear(60.0),
      _paths(longestReachM(description))
{
    for (const Corridor& corridor : ways.keepClear)
        _clear.add({thinned(corridor.line, 1.0), corridor.halfWidthM});
    for (const auto& path : ways.paths)
    {
        _pathLines.push_back(thinned(path, kPathStepM));
        _paths.add({_pathLines.back(), 0.0});
    }
}

void Site::begin(std::uint32_t number)
{
    _number = number;
    _placed = 0;
    _field = &_description.fields[number];
    _dice = models::Dice(seedOf(_description.seed, _field->name));
    _fieldObjects.clear();
    for (const SceneryObject& object : _field->objects)
        _fieldObjects.push_back(static_cast<std::uint32_t>(
            std::find(_objects.begin(), _objects.end(), object) - _objects.begin()));

    constexpr double kBeyondM = 1e7;
    _box = {glm::dvec2(-kBeyondM), glm::dvec2(kBeyondM)};
    const auto cut = [&](glm::dvec2 low, glm::dvec2 high)
    {
        _box.low = glm::max(_box.low, low);
        _box.high = glm::max(_box.low, glm::min(_box.high, high));
    };
    const Where& where = _field->where;
    if (where.circle)
        cut(where.circle->centreM - where.circle->radiusM, where.circle->centreM + where.circle->radiusM);
    glm::dvec2 low(kBeyondM), high(-kBeyondM);
    for (const glm::dvec2& corner : where.polygon)
        low = glm::min(low, corner), high = glm::max(high, corner);
    if (!where.polygon.empty()) cut(low, high);
    if (!where.pathDistanceM) return;
    low = glm::dvec2(kBeyondM), high = glm::dvec2(-kBeyondM);
    for (const auto& line : _pathLines)
        for (const glm::dvec2& place : line)
            low = glm::min(low, place), high = glm::max(high, place);
    cut(low - where.pathDistanceM->most, high + where.pathDistanceM->most);
}

glm::dvec2 Site::anyPlace()
{
    const double east = _dice.between(_box.low.x, _box.high.x);
    return {east, _dice.between(_box.low.y, _box.high.y)};
}

std::uint32_t Site::anyObject()
{
    return _dice.oneOf(_fieldObjects);
}

bool Site::isInArea(glm::dvec2 place) const
{
    const Where& where = _field->where;
    if (where.circle && glm::length(place - where.circle->centreM) > where.circle->radiusM) return false;
    if (!where.polygon.empty() && !isInPolygon(where.polygon, place)) return false;
    return !where.pathDistanceM || where.pathDistanceM->contains(_paths.distanceM(place));
}

bool Site::suits(glm::dvec2 place, double heightM, double slopeDeg) const
{
    const Where& where = _field->where;
    const double elevation = _ground.elevationOf(place.x, place.y, heightM);
    if (!where.heightM.contains(elevation) || !where.slopeDeg.contains(slopeDeg)) return false;
    if (!where.inWater && elevation < _ground.seaLevelM + kLowShoreM) return false;
    if (where.covers.empty() || !_ground.cover) return true;
    const std::string_view cover = _ground.cover(place.x, place.y);
    return std::find(where.covers.begin(), where.covers.end(), cover) != where.covers.end();
}

bool Site::put(std::uint32_t object, glm::dvec2 place, double headingRad, double scale)
{
    const Measures& measures = _measures[object];
    const double room = measures.radiusM * scale + 0.5 * _field->spacingM;
    const double crowding = measures.isCrowned ? _field->crowding : 0.0;
    const Disc disc{place, room, room * (1.0 - crowding)};
    const Where& where = _field->where;
    if (where.patchM > 0.0 && !isInPatch(place, where.patchM, where.patchShare, _description.seed))
        return false;
    if (!isInArea(place) || !isClear(place, measures.radiusM * scale) || !_taken.isFree(disc)) return false;
    const auto footing = standOn(_ground, measures, place, headingRad, scale);
    if (!footing || !suits(place, footing->heightM, footing->slopeDeg)) return false;
    _taken.take(disc);
    placements.push_back({glm::dvec3(place, footing->heightM), footing->axes, scale, _number, object});
    ++_placed;
    return true;
}

void Site::addStreet(const Corridor& street)
{
    _clear.add(street);
    _streets.emplace_back(_number, street);
}

} // namespace scenery
