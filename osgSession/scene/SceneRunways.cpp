// SPDX-License-Identifier: Apache-2.0
#include "SceneRunways.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include <foundation/Angle.h>
#include <foundation/KeptFrom.h>
#include <foundation/NearestOnSegment.h>
#include <foundation/PlainBytes.h>

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

std::optional<SceneTaxiway> taxiwayOf(const GroundFeature& feature)
{
    const auto& style = feature.style;
    if (feature.isArea || style.taxiing != osgTerrainROAM::core::Taxiing::taxiway ||
        style.pavement != osgTerrainROAM::core::Pavement::asphalt)
        return std::nullopt;
    return SceneTaxiway{feature.paths.front(), style.widthM};
}

bool leadsTo(const SceneTaxiway& way, const std::vector<glm::dvec2>& line, double withinM)
{
    return foundation::distanceToLine(way.middle.front(), line) < withinM ||
           foundation::distanceToLine(way.middle.back(), line) < withinM;
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

/// The runways and the paved taxiways of a source.
foundation::Result<SceneAirfields> airfieldsIn(const std::filesystem::path& source,
                                               const osgTerrainROAM::core::RoamTile& tile,
                                               const foundation::KeptFrom& kept)
{
    const auto set = osgTerrainROAM::core::importFeatures(source, tile.tile, kept);
    if (!set) return set.error();
    SceneAirfields airfields;
    airfields.holds = osgTerrainROAM::core::holdingPositions(set->features);
    for (const GroundFeature& feature : set->features)
    {
        if (auto runway = runwayOf(feature)) airfields.runways.push_back(std::move(*runway));
        if (auto way = taxiwayOf(feature)) airfields.taxiways.push_back(std::move(*way));
    }
    return airfields;
}

/// Threshold, course, length, width, and whether it is paved.
using RunwayNumbers = std::array<double, 6>;
/// Place and direction, width, length of the runway.
using HoldNumbers = std::array<double, 6>;

template<class Numbers>
bool areFinite(const Numbers& numbers)
{
    return std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); });
}

} // namespace

std::string bytesOf(const SceneAirfields& airfields)
{
    std::string bytes;
    foundation::appendValue(bytes, static_cast<std::uint64_t>(airfields.runways.size()));
    for (const SceneRunway& runway : airfields.runways)
    {
        const StripRequest& strip = runway.strip;
        foundation::appendValue(bytes,
                                RunwayNumbers{strip.threshold.x, strip.threshold.y, strip.courseDeg,
                                              strip.lengthM, strip.widthM, runway.isPaved ? 1.0 : 0.0});
        foundation::appendText(bytes, runway.designators);
    }
    foundation::appendValue(bytes, static_cast<std::uint64_t>(airfields.taxiways.size()));
    for (const SceneTaxiway& way : airfields.taxiways)
    {
        foundation::appendValue(bytes, way.widthM);
        foundation::appendValues(bytes, way.middle);
    }
    foundation::appendValue(bytes, static_cast<std::uint64_t>(airfields.holds.size()));
    for (const auto& hold : airfields.holds)
    {
        foundation::appendValue(bytes, HoldNumbers{hold.place.x, hold.place.y, hold.away.x, hold.away.y,
                                                   hold.taxiwayM, hold.runwayM});
        foundation::appendText(bytes, hold.runways);
    }
    return bytes;
}

std::optional<SceneAirfields> sceneAirfieldsIn(std::string_view bytes)
{
    foundation::ValueTaker taker(bytes);
    SceneAirfields airfields;
    std::uint64_t count = 0;
    if (!taker.takeCount(count, sizeof(RunwayNumbers))) return std::nullopt;
    airfields.runways.resize(static_cast<std::size_t>(count));
    for (SceneRunway& runway : airfields.runways)
    {
        RunwayNumbers n{};
        if (!taker.take(n) || !taker.take(runway.designators) || !(n[3] >= kLeastM) || !(n[4] > 0.0) ||
            !areFinite(n))
            return std::nullopt;
        runway.strip = {{n[0], n[1]}, n[2], n[3], n[4]};
        runway.isPaved = n[5] != 0.0;
    }
    if (!taker.takeCount(count, sizeof(double))) return std::nullopt;
    airfields.taxiways.resize(static_cast<std::size_t>(count));
    for (SceneTaxiway& way : airfields.taxiways)
        if (!taker.take(way.widthM) || !taker.take(way.middle) || way.middle.empty()) return std::nullopt;
    if (!taker.takeCount(count, sizeof(HoldNumbers))) return std::nullopt;
    airfields.holds.resize(static_cast<std::size_t>(count));
    for (auto& hold : airfields.holds)
    {
        HoldNumbers n{};
        if (!taker.take(n) || !taker.take(hold.runways) || !areFinite(n)) return std::nullopt;
        hold = {{n[0], n[1]}, {n[2], n[3]}, n[4], n[5], std::move(hold.runways)};
    }
    return taker.isEmpty() ? std::optional(std::move(airfields)) : std::nullopt;
}

foundation::Result<SceneAirfields> sceneAirfields(const osgTerrainROAM::core::RoamFile& description,
                                                  const osgTerrainROAM::core::RoamTile& tile)
{
    SceneAirfields airfields;
    std::vector<SceneTaxiway> ways;
    const auto kept = foundation::KeptFrom::ofUser(tile.mark());
    for (const auto& source : description.features)
    {
        auto found = kept.findOrRead(
            "airfields", source, {}, sceneAirfieldsIn, [&] { return airfieldsIn(source, tile, kept); },
            [](const SceneAirfields& made) { return bytesOf(made); });
        if (!found) return found.error();
        airfields.runways.insert(airfields.runways.end(), found->runways.begin(), found->runways.end());
        ways.insert(ways.end(), found->taxiways.begin(), found->taxiways.end());
        airfields.holds.insert(airfields.holds.end(), found->holds.begin(), found->holds.end());
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
