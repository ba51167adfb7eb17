// SPDX-License-Identifier: Apache-2.0
#include "SceneRunways.h"

#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>

#include <osgTerrainROAM/core/features/FeatureImport.h>

namespace trainer
{

namespace
{

using osgTerrainROAM::core::FeatureKind;
using osgTerrainROAM::core::GroundFeature;

constexpr double kLeastM = 100.0;

double courseDegOf(const glm::dvec2& along)
{
    const double course = glm::degrees(std::atan2(along.x, along.y));
    return course < 0.0 ? course + 360.0 : course;
}

std::optional<SceneRunway> runwayOf(const GroundFeature& feature)
{
    if (feature.style.kind != FeatureKind::runway || feature.isArea) return std::nullopt;
    const glm::dvec2 from = feature.paths.front().front(), to = feature.paths.front().back();
    if (glm::distance(from, to) < kLeastM) return std::nullopt;
    SceneRunway runway;
    runway.strip = {from, courseDegOf(to - from), glm::distance(from, to), feature.style.widthM};
    runway.designators = feature.style.designator;
    runway.isPaved = feature.style.pavement == osgTerrainROAM::core::Pavement::asphalt;
    return runway;
}

/// A paved line without marks; whether it is a taxiway depends on what it leads to.
std::optional<SceneTaxiway> taxiwayOf(const GroundFeature& feature)
{
    constexpr double kLeastWideM = 9.0;
    const auto& style = feature.style;
    if (style.kind != FeatureKind::road || feature.isArea || style.marked || style.widthM < kLeastWideM ||
        style.pavement != osgTerrainROAM::core::Pavement::asphalt)
        return std::nullopt;
    return SceneTaxiway{feature.paths.front(), style.widthM};
}

double metresFrom(const glm::dvec2& place, const glm::dvec2& from, const glm::dvec2& to)
{
    const glm::dvec2 way = to - from;
    const double share =
        std::clamp(glm::dot(place - from, way) / std::max(glm::dot(way, way), 1e-9), 0.0, 1.0);
    return glm::distance(place, from + share * way);
}

bool leadsTo(const SceneTaxiway& way, const std::vector<glm::dvec2>& line, double withinM)
{
    for (const glm::dvec2& end : {way.middle.front(), way.middle.back()})
        for (std::size_t i = 0; i + 1 < line.size(); ++i)
            if (metresFrom(end, line[i], line[i + 1]) < withinM) return true;
    return false;
}

/// Keeps those that lead to a runway, and those that lead to these.
std::vector<SceneTaxiway> connected(std::vector<SceneTaxiway> ways, const std::vector<SceneRunway>& runways)
{
    constexpr double kAsideM = 15.0;
    std::vector<SceneTaxiway> found;
    const auto isConnected = [&](const SceneTaxiway& way)
    {
        for (const SceneRunway& runway : runways)
        {
            const double course = foundation::radiansOf(runway.strip.courseDeg);
            const glm::dvec2 from = runway.strip.threshold,
                             to =
                                 from + runway.strip.lengthM * glm::dvec2(std::sin(course), std::cos(course));
            if (leadsTo(way, {from, to}, 0.5 * runway.strip.widthM + kAsideM)) return true;
        }
        return std::any_of(found.begin(), found.end(),
                           [&](const SceneTaxiway& other)
                           { return leadsTo(way, other.middle, 0.5 * other.widthM + kAsideM); });
    };
    for (bool isMore = true; isMore;)
    {
        const auto rest = std::stable_partition(ways.begin(), ways.end(),
                                                [&](const SceneTaxiway& way) { return !isConnected(way); });
        isMore = rest != ways.end();
        found.insert(found.end(), rest, ways.end());
        ways.erase(rest, ways.end());
    }
    return found;
}

/// The same runway from its other end.
StripRequest turned(StripRequest strip)
{
    const double course = foundation::radiansOf(strip.courseDeg);
    strip.threshold += strip.lengthM * glm::dvec2(std::sin(course), std::cos(course));
    strip.courseDeg = std::fmod(strip.courseDeg + 180.0, 360.0);
    return strip;
}

} // namespace

foundation::Result<SceneAirfields> sceneAirfields(const osgTerrainROAM::core::RoamFile& description,
                                                  const osgTerrainROAM::core::RoamTile& tile)
{
    SceneAirfields airfields;
    std::vector<SceneTaxiway> ways;
    const auto kept = foundation::KeptFrom::ofUser(tile.mark());
    for (const auto& source : description.features)
    {
        const auto set = osgTerrainROAM::core::importFeatures(source, tile.tile, kept);
        if (!set) return set.error();
        for (const GroundFeature& feature : set->features)
        {
            if (auto runway = runwayOf(feature)) airfields.runways.push_back(std::move(*runway));
            if (auto way = taxiwayOf(feature)) ways.push_back(std::move(*way));
        }
    }
    if (!airfields.runways.empty()) airfields.taxiways = connected(std::move(ways), airfields.runways);
    return airfields;
}

std::optional<StripRequest> runwayInUse(const std::vector<SceneRunway>& runways,
                                        const std::optional<double>& windFromDeg)
{
    const auto worse = [](const SceneRunway& a, const SceneRunway& b)
    { return a.isPaved != b.isPaved ? b.isPaved : a.strip.lengthM < b.strip.lengthM; };
    const auto best = std::max_element(runways.begin(), runways.end(), worse);
    if (best == runways.end()) return std::nullopt;
    const bool isTailwind =
        windFromDeg && std::cos(foundation::radiansOf(*windFromDeg - best->strip.courseDeg)) < 0.0;
    return isTailwind ? turned(best->strip) : best->strip;
}

} // namespace trainer
