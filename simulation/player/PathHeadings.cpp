// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/PathHeadings.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace simulation
{
namespace
{

constexpr double kSamePlaceM = 1e-9;
constexpr double kCornerM = 2.0;

/// The angle nearest to `reference` among those that differ from `angle` by full turns.
double near(double angle, double reference)
{
    return angle + 2.0 * std::numbers::pi * std::round((reference - angle) / (2.0 * std::numbers::pi));
}

/// Headings at rising parameters, unwrapped.
class HeadingKnots
{
public:
    void append(double parameter, double heading)
    {
        if (!_parameters.empty() && !(parameter > _parameters.back())) return;
        _parameters.push_back(parameter);
        _headings.push_back(_headings.empty() ? heading : near(heading, _headings.back()));
    }

    std::optional<CubicSpline> spline()
    {
        if (_parameters.empty()) return std::nullopt;
        if (_parameters.size() == 1) append(_parameters.back() + 1.0, _headings.back());
        return CubicSpline(_parameters, _headings, CubicSpline::Kind::linear);
    }

private:
    std::vector<double> _parameters;
    std::vector<double> _headings;
};

} // namespace

std::optional<CubicSpline> vertexAngles(const std::vector<PathVertex>& vertices,
                                        std::optional<double> Orientation::*member, CubicSpline::Kind kind)
{
    std::vector<double> knots;
    std::vector<double> values;
    for (const PathVertex& vertex : vertices)
    {
        const std::optional<double>& angle = vertex.orientation.*member;
        if (!angle) return std::nullopt;
        knots.push_back(vertex.parameter);
        values.push_back(values.empty() ? *angle : near(*angle, values.back()));
    }
    return CubicSpline(std::move(knots), std::move(values), kind);
}

std::optional<CubicSpline> givenHeadings(const std::vector<PathVertex>& vertices)
{
    HeadingKnots knots;
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
        knots.append(0.5 * (vertices[i].parameter + vertices[i + 1].parameter),
                     *vertices[i].orientation.headingRad);
    knots.append(vertices.back().parameter, *vertices.back().orientation.headingRad);
    return knots.spline();
}

std::optional<CubicSpline> segmentHeadings(const std::vector<PathVertex>& vertices)
{
    HeadingKnots knots;
    std::optional<double> before;
    double beforeShare = 0.0; // of the last segment, in parameters, that its end's turn takes
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
    {
        const glm::dvec3 along = vertices[i + 1].position - vertices[i].position;
        if (std::hypot(along.x, along.y) < kSamePlaceM) continue;
        const double width = vertices[i + 1].parameter - vertices[i].parameter;
        const double share = width * std::min(0.5, kCornerM / glm::length(along));
        const double heading = near(std::atan2(along.y, along.x), before.value_or(0.0));
        if (before)
        {
            knots.append(vertices[i].parameter - beforeShare, *before);
            knots.append(vertices[i].parameter, 0.5 * (*before + heading));
        }
        knots.append(vertices[i].parameter + (before ? share : 0.0), heading);
        before = heading;
        beforeShare = share;
    }
    return knots.spline();
}

} // namespace simulation
