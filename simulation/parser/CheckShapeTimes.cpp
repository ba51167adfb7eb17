// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "simulation/parser/ElementParsers.h"

namespace simulation
{
namespace
{

std::vector<std::optional<double>> timesOf(const TrajectoryShape& shape)
{
    std::vector<std::optional<double>> times;
    if (const auto* polyline = std::get_if<Polyline>(&shape))
        for (const Vertex& vertex : polyline->vertices)
            times.push_back(vertex.timeS);
    if (const auto* clothoid = std::get_if<Clothoid>(&shape))
        times = {clothoid->startTimeS, clothoid->stopTimeS};
    if (const auto* spline = std::get_if<ClothoidSpline>(&shape))
    {
        for (const ClothoidSpline::Segment& segment : spline->segments)
            times.push_back(segment.timeStartS);
        times.push_back(spline->timeEndS);
    }
    if (const auto* nurbs = std::get_if<Nurbs>(&shape))
        for (const Nurbs::ControlPoint& point : nurbs->points)
            times.push_back(point.timeS);
    return times;
}

/// Names a time of a shape for a message.
std::string nameOfTime(const TrajectoryShape& shape, std::size_t index)
{
    if (std::holds_alternative<Clothoid>(shape)) return index == 0 ? "startTime" : "stopTime";
    if (const auto* spline = std::get_if<ClothoidSpline>(&shape))
        return index < spline->segments.size() ? "the timeStart of segment " + std::to_string(index + 1)
                                               : "timeEnd";
    return "the time of control point " + std::to_string(index + 1);
}

std::string nameOfVertex(const Polyline& polyline, std::size_t index)
{
    return "vertex " + std::to_string(index + 1) + " (line " +
           std::to_string(polyline.vertices[index].source.line) + ")";
}

bool isAtOneTime(const Vertex& left, const Vertex& right)
{
    return left.timeS && right.timeS && !Vertex::isLater(*left.timeS, *right.timeS) &&
           !Vertex::isLater(*right.timeS, *left.timeS);
}

/// Recordings have samples twice at times that were rounded.
void dropRepeated(ParseContext& context, pugi::xml_node holder, Polyline& polyline)
{
    std::vector<Vertex>& vertices = polyline.vertices;
    const auto first = std::adjacent_find(vertices.begin(), vertices.end(), isAtOneTime);
    if (first == vertices.end()) return;
    const auto index = static_cast<std::size_t>(first - vertices.begin()) + 1;
    std::vector<Vertex> kept = vertices;
    kept.erase(std::unique(kept.begin(), kept.end(), isAtOneTime), kept.end());
    if (kept.size() < 2) return;
    context.assumed(holder, "the time of " + nameOfVertex(polyline, index) + " is that of the one before",
                    "it is left out; give it a later time");
    vertices = std::move(kept);
}

void checkVertexTimes(ParseContext& context, pugi::xml_node holder, const Polyline& polyline)
{
    for (std::size_t i = 0; i < polyline.vertices.size(); ++i)
    {
        const std::optional<double>& time = polyline.vertices[i].timeS;
        if (!time)
            context.invalid(holder,
                            nameOfVertex(polyline, i) + " has no time, but the trajectory has a Timing",
                            "add its time");
        else if (i > 0 && !Vertex::isLater(*polyline.vertices[i - 1].timeS, *time))
            context.invalid(holder,
                            "the time of " + nameOfVertex(polyline, i) + " is not later than the one before",
                            "order the vertices");
        else
            continue;
        return;
    }
}

void checkTimes(ParseContext& context, pugi::xml_node holder, const TrajectoryShape& shape,
                const std::vector<std::optional<double>>& times)
{
    for (std::size_t i = 0; i < times.size(); ++i)
    {
        if (!times[i])
            context.invalid(holder, nameOfTime(shape, i) + " is missing, but the trajectory has a Timing",
                            "add it");
        else if (i > 0 && !Vertex::isLater(*times[i - 1], *times[i]))
            context.invalid(holder, nameOfTime(shape, i) + " is not later than the one before",
                            "let times rise");
        else
            continue;
        return;
    }
}

} // namespace

bool checkShapeTimes(ParseContext& context, pugi::xml_node holder, TrajectoryShape& shape)
{
    const std::vector<std::optional<double>> times = timesOf(shape);
    const auto hasTime = [](const std::optional<double>& time) { return time.has_value(); };
    if (!times.empty() && std::none_of(times.begin(), times.end(), hasTime))
    {
        context.assumed(holder, "the trajectory has a Timing, but no times",
                        "the speed of the entity moves it; add times");
        return false;
    }
    if (auto* polyline = std::get_if<Polyline>(&shape))
    {
        dropRepeated(context, holder, *polyline);
        checkVertexTimes(context, holder, *polyline);
    }
    else
        checkTimes(context, holder, shape, times);
    return true;
}

} // namespace simulation
