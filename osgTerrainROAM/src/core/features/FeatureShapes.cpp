// SPDX-License-Identifier: Apache-2.0
#include "FeatureShapes.h"

#include <algorithm>
#include <cmath>

#include "RoadChains.h"
#include "TaxiwayStrokes.h"

namespace osgTerrainROAM::core
{

namespace
{

int codeOf(const FeatureStyle& style)
{
    return static_cast<int>(style.kind) + 4 * static_cast<int>(style.pavement) +
           16 * std::min(style.lanes, 15) + 256 * (style.marked ? 1 : 0);
}

/// One of 64 shades from a position: neighbours differ, and the same map gives the same shades.
int seedOf(const glm::dvec2& place)
{
    const auto x = static_cast<std::uint64_t>(std::llround(place.x));
    const auto y = static_cast<std::uint64_t>(std::llround(place.y));
    std::uint64_t h = x * 0x9E3779B97F4A7C15u + y * 0xC2B2AE3D27D4EB4Fu;
    h = (h ^ (h >> 29)) * 0xBF58476D1CE4E5B9u;
    return static_cast<int>((h >> 40) & 63);
}

/// The direction of rows: along the longest side, as farmers drive.
glm::dvec2 longestSide(const Ring& ring)
{
    glm::dvec2 longest(0.0);
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (const glm::dvec2 side = ring[(i + 1) % ring.size()] - ring[i];
            glm::length(side) > glm::length(longest))
            longest = side;
    return glm::length(longest) > 0.0 ? glm::normalize(longest) : glm::dvec2(1.0, 0.0);
}

FeatureShapes::Area areaOf(const GroundFeature& feature)
{
    FeatureShapes::Area area{feature.paths, feature.style.kind, feature.style.crop,
                             seedOf(feature.paths[0][0]), longestSide(feature.paths[0])};
    // Farmland of unknown crop: two of three fields bear cereals.
    const bool isOpen =
        area.kind == FeatureKind::field && area.crop == Crop::cereal && !feature.style.isCropKnown;
    if (isOpen && area.seed % 3 == 0) area.crop = Crop::rowCrop;
    return area;
}

void addSegments(std::vector<FeatureShapes::Segment>& segments, const Chain& chain, int line)
{
    double way = 0.0;
    for (std::size_t i = 0; i + 1 < chain.points.size(); ++i)
    {
        const glm::dvec2 &a = chain.points[i], &b = chain.points[i + 1];
        const double length = glm::distance(a, b);
        if (length <= 0.0) continue;
        segments.push_back({a, b, 0.5 * chain.style.widthM, std::fmod(way, FeatureCells::kWayPeriodM),
                            codeOf(chain.style), line});
        way += length;
    }
}

void addStrokes(std::vector<Stroke>& strokes, const std::vector<Stroke>& more)
{
    strokes.insert(strokes.end(), more.begin(), more.end());
}

} // namespace

FeatureShapes::FeatureShapes(const std::vector<GroundFeature>& features)
{
    for (const GroundFeature& feature : features)
        if (feature.isArea) areas.push_back(areaOf(feature));
    runways = runwaysOf(features);
    for (const RunwayFrame& runway : runways)
        addStrokes(strokes, runwayStrokes(runway));
    int line = 0;
    for (const Chain& chain : joinedLines(features))
    {
        if (chain.style.kind == FeatureKind::runway) continue;
        addSegments(segments, chain, line++);
        if (isPavedTaxiway(chain.style))
            addStrokes(strokes, taxiwayStrokes(chain.points, chain.style.widthM, runways));
    }
    const auto byKind = [](const Segment& a, const Segment& b) { return (a.code & 3) < (b.code & 3); };
    std::stable_sort(segments.begin(), segments.end(), byKind);
    std::stable_sort(areas.begin(), areas.end(),
                     [](const Area& a, const Area& b) { return a.kind < b.kind; });
    std::stable_sort(strokes.begin(), strokes.end(),
                     [](const Stroke& a, const Stroke& b) { return a.paint < b.paint; });
}

} // namespace osgTerrainROAM::core
