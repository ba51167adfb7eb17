// SPDX-License-Identifier: Apache-2.0
#include "simulation/tour/DriveTiming.h"

#include <algorithm>
#include <cmath>

namespace simulation
{
namespace
{

constexpr double kSidewaysMps2 = 2.0;
constexpr double kAlongMps2 = 1.5;
constexpr double kVertexEveryS = 0.5;
constexpr double kSlowestDriveMps = 0.5; ///< of a step, so that a way to a stop takes no endless time

/// Of the circle through three places; 0 on a line.
double curvature(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    const glm::dvec2 ab = b - a;
    const glm::dvec2 bc = c - b;
    const double product = glm::length(ab) * glm::length(bc) * glm::length(c - a);
    return product > 0.0 ? 2.0 * std::fabs(ab.x * bc.y - ab.y * bc.x) / product : 0.0;
}

double planDistance(const WayPoint& a, const WayPoint& b)
{
    return glm::length(glm::dvec2(b.place - a.place));
}

} // namespace

std::vector<double> limitsOn(const std::vector<WayPoint>& way)
{
    std::vector<double> speed;
    for (const WayPoint& point : way)
        speed.push_back(point.limitMps);
    for (std::size_t i = 1; i + 1 < way.size(); ++i)
    {
        const double bend = curvature(way[i - 1].place, way[i].place, way[i + 1].place);
        if (bend > 0.0) speed[i] = std::min(speed[i], std::sqrt(kSidewaysMps2 / bend));
    }
    return speed;
}

std::vector<double> reachable(const std::vector<WayPoint>& way, std::vector<double> speedMps)
{
    const auto from = [&](std::size_t a, std::size_t b)
    { return std::sqrt(speedMps[a] * speedMps[a] + 2.0 * kAlongMps2 * planDistance(way[a], way[b])); };
    for (std::size_t i = 1; i < way.size(); ++i)
        speedMps[i] = std::min(speedMps[i], from(i - 1, i));
    for (std::size_t i = way.size() - 1; i-- > 0;)
        speedMps[i] = std::min(speedMps[i], from(i + 1, i));
    return speedMps;
}

std::vector<PathVertex> timedVertices(const std::vector<WayPoint>& way, const std::vector<double>& speedMps,
                                      double durationS)
{
    std::vector<PathVertex> vertices;
    double time = 0.0;
    for (std::size_t i = 0; i + 1 < way.size(); ++i)
    {
        const double mean = std::max(kSlowestDriveMps, 0.5 * (speedMps[i] + speedMps[i + 1]));
        const double takes = planDistance(way[i], way[i + 1]) / mean;
        for (double due = static_cast<double>(vertices.size()) * kVertexEveryS;
             due < time + takes && due <= durationS;
             due = static_cast<double>(vertices.size()) * kVertexEveryS)
            vertices.push_back({due, glm::mix(way[i].place, way[i + 1].place, (due - time) / takes), {}});
        time += takes;
    }
    return vertices;
}

} // namespace simulation
