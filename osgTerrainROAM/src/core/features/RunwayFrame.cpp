// SPDX-License-Identifier: Apache-2.0
#include "RunwayFrame.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <foundation/NearestOnSegment.h>

namespace osgTerrainROAM::core
{

namespace
{

bool liesOn(const RunwayFrame& line, const RunwayFrame& area)
{
    constexpr double kParallel = 0.95;
    const glm::dvec2 middle = 0.5 * (line.a + line.b);
    const double asideM = glm::distance(middle, foundation::nearestOnSegment(middle, area.a, area.b));
    return asideM <= 0.5 * area.widthM &&
           std::fabs(glm::dot(glm::normalize(line.b - line.a), glm::normalize(area.b - area.a))) > kParallel;
}

} // namespace

std::vector<RunwayFrame> runwaysOf(const std::vector<GroundFeature>& features)
{
    std::vector<RunwayFrame> lines, areas;
    for (const GroundFeature& feature : features)
    {
        if (feature.style.kind != FeatureKind::runway) continue;
        RunwayFrame frame{{}, {}, feature.style.widthM, feature.style.designator};
        frame.isPaved = feature.style.pavement == Pavement::asphalt;
        if (feature.isArea)
        {
            if (runwayOfArea(feature.paths, frame)) areas.push_back(frame);
            continue;
        }
        for (const auto& path : feature.paths)
        {
            frame.a = path.front();
            frame.b = path.back();
            if (frame.a != frame.b) lines.push_back(frame);
        }
    }
    std::vector<RunwayFrame> runways = lines;
    std::copy_if(areas.begin(), areas.end(), std::back_inserter(runways),
                 [&](const RunwayFrame& area)
                 {
                     return std::none_of(lines.begin(), lines.end(),
                                         [&](const RunwayFrame& line) { return liesOn(line, area); });
                 });
    return runways;
}

bool runwayOfArea(const std::vector<std::vector<glm::dvec2>>& rings, RunwayFrame& frame)
{
    glm::dvec2 along(0.0);
    const auto& ring = rings.front();
    // The direction of the sum of all sides, folded into one half plane: points added on a straight side
    // change nothing.
    glm::dvec2 longest(0.0);
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (const glm::dvec2 side = ring[(i + 1) % ring.size()] - ring[i];
            glm::length(side) > glm::length(longest))
            longest = side;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
        const glm::dvec2 side = ring[(i + 1) % ring.size()] - ring[i];
        const double cosine = glm::dot(side, longest);
        if (std::abs(cosine) > 0.99 * glm::length(side) * glm::length(longest))
            along += cosine < 0.0 ? -side : side;
    }
    if (glm::length(along) <= 0.0) return false;
    along = glm::normalize(along);
    const glm::dvec2 across(along.y, -along.x);
    glm::dvec2 low(1e300), high(-1e300);
    for (const glm::dvec2& point : ring)
    {
        const glm::dvec2 place(glm::dot(point, along), glm::dot(point, across));
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    if (high.x - low.x < 5.0 * (high.y - low.y)) return false;
    const double middle = 0.5 * (low.y + high.y);
    frame.a = low.x * along + middle * across;
    frame.b = high.x * along + middle * across;
    frame.widthM = high.y - low.y;
    frame.hasBed = false;
    return true;
}

std::pair<std::string, std::string> designatorsOf(const RunwayFrame& frame)
{
    const std::string& text = frame.designator;
    if (const std::size_t slash = text.find('/'); slash != std::string::npos && text.size() <= 7)
        return {text.substr(0, slash), text.substr(slash + 1)};
    const glm::dvec2 along = frame.b - frame.a;
    const double headingDeg = glm::degrees(std::atan2(along.x, along.y));
    const int tens = (static_cast<int>(std::lround(headingDeg / 10.0)) + 35) % 36 + 1;
    const auto two = [](int n) { return std::string(n < 10 ? "0" : "") + std::to_string(n); };
    return {two(tens), two((tens + 17) % 36 + 1)};
}

} // namespace osgTerrainROAM::core
