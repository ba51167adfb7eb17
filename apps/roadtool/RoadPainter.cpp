// SPDX-License-Identifier: Apache-2.0
#include "roadtool/RoadPainter.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/MarkStrokes.h>
#include <osgRoads/core/query/ObjectInstances.h>
#include <osgRoads/core/query/RoadSurface.h>

#include "roadtool/Palette.h"

namespace roadtool
{

namespace
{

using namespace osgRoads::core;

constexpr double kChordErrorM = 0.05;
constexpr double kShortestM = 0.5, kLongestM = 10.0;
constexpr double kJointM = 0.2; ///< lanes reach over their ends by this, so that no seam shows between roads
constexpr std::size_t kMostDrawnObjects = 200000;
constexpr int kCircleCorners = 12;
constexpr double kSignalM = 0.6; ///< radius of the dot of a signal

/// Makes the polygons of one road.
class RoadPainter
{
public:
    RoadPainter(const Road& road, double shortestM, std::vector<FilledPolygon>& polygons)
        : _road(road), _shortestM(shortestM), _polygons(polygons)
    {
    }

    void paintLanes()
    {
        for (const LaneSection& section : _road.sections)
            for (const auto* side : {&section.right, &section.left})
                for (const Lane& lane : *side)
                    if (lane.type != LaneType::none) paintLane(section, lane);
    }

    void paintMarks()
    {
        for (const LaneSection& section : _road.sections)
        {
            paintMarksOf(section, section.centre);
            for (const auto* side : {&section.left, &section.right})
                for (const Lane& lane : *side)
                    paintMarksOf(section, lane);
        }
    }

    void paintObjects()
    {
        for (const RoadObject& object : _road.objects)
        {
            for (const ObjectOutline& outline : object.outlines)
                add(plan(outlineCorners(_road, object, outline)), kObject);
            if (!object.outlines.empty()) continue;
            for (const ObjectInstance& instance : objectInstances(object))
                if (_polygons.size() < _mostPolygons) paintInstance(instance);
        }
        for (const Signal& signal : _road.signals)
            paintDisc(at(signal.s, signal.t), kSignalM, kSignal);
    }

private:
    using Edge = std::function<double(double s)>;

    static std::vector<glm::dvec2> plan(const std::vector<glm::dvec3>& points)
    {
        return {points.begin(), points.end()};
    }

    glm::dvec2 at(double s, double t) const { return glm::dvec2(surfacePoint(_road, s, t)); }

    void add(std::vector<glm::dvec2> corners, Colour colour)
    {
        if (corners.size() >= 3) _polygons.push_back({std::move(corners), colour});
    }

    /// The s between two others at which a strip gets corners.
    std::vector<double> samples(double from, double to) const
    {
        std::vector<double> found{from};
        while (found.back() < to)
        {
            const PlanElement& element = _road.referenceLine.elementAt(found.back());
            const double curvature = std::fabs(element.at(found.back() - element.s).curvature);
            const double step = std::sqrt(8.0 * kChordErrorM / std::max(curvature, 1e-6));
            found.push_back(found.back() + std::clamp(step, std::max(kShortestM, _shortestM),
                                                      std::max(kLongestM, _shortestM)));
        }
        found.back() = to;
        return found;
    }

    /// A strip between two lateral functions of s.
    void paintStrip(double from, double to, const Edge& left, const Edge& right, Colour colour)
    {
        if (!(to > from)) return;
        std::vector<glm::dvec2> corners, back;
        for (const double s : samples(from, to))
        {
            corners.push_back(at(s, left(s)));
            back.push_back(at(s, right(s)));
        }
        corners.insert(corners.end(), back.rbegin(), back.rend());
        add(std::move(corners), colour);
    }

    void paintLane(const LaneSection& section, const Lane& lane)
    {
        const double end = std::min(section.end, _road.length);
        const auto border = [&](bool isOuter)
        {
            return [this, &section, &lane, isOuter, end](double beyond)
            {
                const double s = std::clamp(beyond, section.s, std::max(end, section.s));
                double t = 0.0;
                forLanesOutwards(_road, section, lane.id > 0 ? 1 : -1, s,
                                 [&](const LaneSpan& span)
                                 {
                                     t = isOuter ? span.outerT : span.innerT;
                                     return span.lane != &lane;
                                 });
                return t;
            };
        };
        if (end > section.s)
            paintStrip(section.s - kJointM, end + kJointM, border(true), border(false), colourOf(lane.type));
    }

    void paintMarksOf(const LaneSection& section, const Lane& lane)
    {
        for (const MarkStroke& stroke : markStrokes(_road, section, lane))
        {
            const auto edge = [&](double side)
            {
                return [this, &section, &stroke, side](double s)
                { return strokeT(_road, section, stroke, s) + side * 0.5 * stroke.width; };
            };
            paintStrip(stroke.sStart, stroke.sEnd, edge(1.0), edge(-1.0), colourOf(stroke.colour));
        }
    }

    void paintInstance(const ObjectInstance& instance)
    {
        if (instance.isStretch)
        {
            const double span = instance.sEnd - instance.s;
            const auto edge = [&](double side)
            {
                return [&instance, span, side](double s)
                {
                    const double share = span > 0.0 ? (s - instance.s) / span : 0.0;
                    const double width = instance.width + (instance.widthEnd - instance.width) * share;
                    return instance.t + (instance.tEnd - instance.t) * share +
                           side * 0.5 * std::max(width, 0.1);
                };
            };
            paintStrip(std::max(instance.s, 0.0), std::min(instance.sEnd, _road.length), edge(1.0),
                       edge(-1.0), kObject);
        }
        else if (instance.radius > 0.0 || instance.length <= 0.0 || instance.width <= 0.0)
            paintDisc(at(instance.s, instance.t), std::max(instance.radius, 0.2), kObject);
        else
            paintBox(instance);
    }

    void paintBox(const ObjectInstance& instance)
    {
        const double heading = frameAt(_road, instance.s).headingRad + instance.headingRad;
        const glm::dvec2 along(std::cos(heading), std::sin(heading)), left(-along.y, along.x);
        const glm::dvec2 middle = at(instance.s, instance.t);
        const glm::dvec2 u = 0.5 * instance.length * along, v = 0.5 * instance.width * left;
        add({middle - u - v, middle + u - v, middle + u + v, middle - u + v}, kObject);
    }

    void paintDisc(glm::dvec2 middle, double radius, Colour colour)
    {
        std::vector<glm::dvec2> corners;
        for (int i = 0; i < kCircleCorners; ++i)
        {
            const double angle = 2.0 * std::numbers::pi * i / kCircleCorners;
            corners.push_back(middle + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
        }
        add(std::move(corners), colour);
    }

    const Road& _road;
    double _shortestM;
    std::vector<FilledPolygon>& _polygons;
    std::size_t _mostPolygons = _polygons.size() + kMostDrawnObjects;
};

} // namespace

void paintLanes(const Road& road, double shortestM, std::vector<FilledPolygon>& polygons)
{
    RoadPainter(road, shortestM, polygons).paintLanes();
}

void paintMarks(const Road& road, double shortestM, std::vector<FilledPolygon>& polygons)
{
    RoadPainter(road, shortestM, polygons).paintMarks();
}

void paintObjects(const Road& road, double shortestM, std::vector<FilledPolygon>& polygons)
{
    RoadPainter(road, shortestM, polygons).paintObjects();
}

} // namespace roadtool
