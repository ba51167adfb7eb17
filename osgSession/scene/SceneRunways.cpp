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

/// The same runway from its other end.
StripRequest turned(StripRequest strip)
{
    const double course = foundation::radiansOf(strip.courseDeg);
    strip.threshold += strip.lengthM * glm::dvec2(std::sin(course), std::cos(course));
    strip.courseDeg = std::fmod(strip.courseDeg + 180.0, 360.0);
    return strip;
}

} // namespace

foundation::Result<std::vector<SceneRunway>> sceneRunways(const osgTerrainROAM::core::RoamFile& description,
                                                          const osgTerrainROAM::core::RoamTile& tile)
{
    std::vector<SceneRunway> runways;
    const auto kept = foundation::KeptFrom::ofUser(tile.mark());
    for (const auto& source : description.features)
    {
        const auto set = osgTerrainROAM::core::importFeatures(source, tile.tile, kept);
        if (!set) return set.error();
        for (const GroundFeature& feature : set->features)
            if (auto runway = runwayOf(feature)) runways.push_back(std::move(*runway));
    }
    return runways;
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
