// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/madeup/SmoothPath.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace worldmaking
{

namespace
{

constexpr double kControlM = 150.0, kRoundM = 60.0;
constexpr int kFine = 12; ///< points of the spline a span, before they are spread evenly

/// The uniform cubic B-spline of control points, with both ends three times: it begins and ends in them.
std::vector<glm::dvec2> splineOf(const std::vector<glm::dvec2>& control)
{
    if (control.size() < 3) return control;
    std::vector<glm::dvec2> points(2, control.front());
    points.insert(points.end(), control.begin(), control.end());
    points.insert(points.end(), 2, control.back());
    std::vector<glm::dvec2> line;
    for (std::size_t i = 0; i + 3 < points.size(); ++i)
        for (int step = 0; step < kFine; ++step)
        {
            const double t = static_cast<double>(step) / kFine, s = 1.0 - t;
            line.push_back((s * s * s * points[i] + (3.0 * t * t * t - 6.0 * t * t + 4.0) * points[i + 1] +
                            (-3.0 * t * t * t + 3.0 * t * t + 3.0 * t + 1.0) * points[i + 2] +
                            t * t * t * points[i + 3]) /
                           6.0);
        }
    line.front() = control.front();
    line.push_back(control.back());
    return line;
}

} // namespace

std::vector<glm::dvec2> evenPoints(const std::vector<glm::dvec2>& line, double stepM)
{
    double lengthM = 0.0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        lengthM += glm::distance(line[i], line[i + 1]);
    const int steps = std::max(1, static_cast<int>(std::lround(lengthM / stepM)));
    std::vector<glm::dvec2> even{line.front()};
    double passed = 0.0;
    std::size_t i = 0;
    for (int step = 1; step < steps; ++step)
    {
        const double wanted = lengthM * step / steps;
        while (i + 2 < line.size() && passed + glm::distance(line[i], line[i + 1]) < wanted)
            passed += glm::distance(line[i], line[i + 1]), ++i;
        const double piece = std::max(glm::distance(line[i], line[i + 1]), 1e-9);
        even.push_back(glm::mix(line[i], line[i + 1], std::clamp((wanted - passed) / piece, 0.0, 1.0)));
    }
    even.push_back(line.back());
    return even;
}

std::vector<glm::dvec2> smoothPath(const std::vector<glm::dvec2>& steps)
{
    return evenPoints(splineOf(evenPoints(steps, kControlM)), kCourseStepM);
}

std::vector<glm::dvec2> roundedPath(const std::vector<glm::dvec2>& path)
{
    return evenPoints(splineOf(evenPoints(path, kRoundM)), kCourseStepM);
}

double lengthOf(const std::vector<glm::dvec2>& line)
{
    double lengthM = 0.0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        lengthM += glm::distance(line[i], line[i + 1]);
    return lengthM;
}

} // namespace worldmaking
