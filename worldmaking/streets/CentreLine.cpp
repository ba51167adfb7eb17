// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/CentreLine.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <foundation/Angle.h>
#include <glm/geometric.hpp>

namespace worldmaking
{

namespace
{

using osgRoads::core::ArcShape;
using osgRoads::core::LineShape;
using osgRoads::core::PlanElement;

constexpr double kStraightRad = 1e-4; ///< less of a turn is made by the line alone
constexpr double kShareOfLine = 0.499;
constexpr double kNoLengthM = 1e-3;

/// Puts elements one behind the other.
class LineBuilder
{
public:
    void addLine(glm::dvec2 from, glm::dvec2 to)
    {
        const glm::dvec2 way = to - from;
        const double length = glm::length(way);
        if (length < kNoLengthM) return;
        add(length, from, std::atan2(way.y, way.x), LineShape{});
    }

    void addArc(glm::dvec2 from, double headingRad, double radius, double turnRad)
    {
        add(radius * std::fabs(turnRad), from, headingRad, ArcShape{std::copysign(1.0 / radius, turnRad)});
    }

    double lengthM = 0.0;
    std::vector<PlanElement> elements;

private:
    void add(double length, glm::dvec2 from, double headingRad, const PlanElement::Shape& shape)
    {
        elements.emplace_back(lengthM, length, from, headingRad, shape);
        lengthM += length;
    }
};

/// The bend at a point: how far before and after it the arc reaches.
struct Bend
{
    double turnRad = 0.0;
    double reachM = 0.0;

    bool isArc() const { return reachM > kNoLengthM; }
    double radiusM() const { return reachM / std::tan(0.5 * std::fabs(turnRad)); }
};

Bend bendAt(glm::dvec2 before, glm::dvec2 point, glm::dvec2 after)
{
    const glm::dvec2 in = point - before, out = after - point;
    const double turn = foundation::wrappedRad(std::atan2(out.y, out.x) - std::atan2(in.y, in.x));
    if (std::fabs(turn) < kStraightRad) return {};
    const double room = kShareOfLine * std::min(glm::length(in), glm::length(out));
    // The middle of the arc lies reach · tan(turn / 4) from the point.
    return {turn, std::min(room, CentreLine::kMostOffsetM / std::tan(0.25 * std::fabs(turn)))};
}

} // namespace

CentreLine::CentreLine(const std::vector<glm::dvec2>& points)
{
    const std::vector<std::size_t> kept = keep(points);
    LineBuilder line;
    std::vector<double> keptM = {0.0};
    glm::dvec2 from = points[kept.front()];
    for (std::size_t i = 1; i + 1 < kept.size(); ++i)
    {
        const glm::dvec2 before = points[kept[i - 1]], point = points[kept[i]], after = points[kept[i + 1]];
        const Bend bend = bendAt(before, point, after);
        const glm::dvec2 in = glm::normalize(point - before);
        const glm::dvec2 start = point - bend.reachM * in;
        line.addLine(from, start);
        from = start;
        keptM.push_back(line.lengthM);
        if (!bend.isArc()) continue;
        const double arcM = bend.radiusM() * std::fabs(bend.turnRad);
        line.addArc(start, std::atan2(in.y, in.x), bend.radiusM(), bend.turnRad);
        keptM.back() += 0.5 * arcM;
        from = point + bend.reachM * glm::normalize(after - point);
    }
    line.addLine(from, points[kept.back()]);
    keptM.push_back(line.lengthM);
    _lengthM = line.lengthM;
    _line = osgRoads::core::ReferenceLine(std::move(line.elements));
    for (std::size_t i = 0, next = 0; i < points.size(); ++i)
    {
        if (next + 1 < kept.size() && kept[next + 1] <= i) ++next;
        _pointsM.push_back(keptM[next]);
    }
}

/// Ends are always kept; the last point is, and then the one before it goes.
std::vector<std::size_t> CentreLine::keep(const std::vector<glm::dvec2>& points) const
{
    std::vector<std::size_t> kept = {0};
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
        if (glm::distance(points[kept.back()], points[i]) >= kLeastStepM) kept.push_back(i);
    while (kept.size() > 1 && glm::distance(points[kept.back()], points.back()) < kLeastStepM)
        kept.pop_back();
    kept.push_back(points.size() - 1);
    return kept;
}

double CentreLine::leastRadiusM() const
{
    double radius = std::numeric_limits<double>::infinity();
    for (const PlanElement& element : _line.elements())
        if (const auto* arc = std::get_if<ArcShape>(&element.shape()))
            radius = std::min(radius, 1.0 / std::fabs(arc->curvature));
    return radius;
}

osgRoads::core::ReferenceLine CentreLine::part(double fromM, double toM) const
{
    std::vector<PlanElement> elements;
    for (const PlanElement& element : _line.elements())
    {
        const double start = std::max(element.s, fromM), end = std::min(element.s + element.length, toM);
        if (end - start < kNoLengthM) continue;
        const auto point = element.at(start - element.s);
        elements.emplace_back(start - fromM, end - start, point.position, point.headingRad, element.shape());
    }
    if (!elements.empty()) // lengths that were left out go to the ends
    {
        const PlanElement& first = elements.front();
        const auto point = at(fromM);
        elements.front() =
            PlanElement(0.0, first.length + first.s, point.position, point.headingRad, first.shape());
        elements.back().length = toM - fromM - elements.back().s;
    }
    return osgRoads::core::ReferenceLine(std::move(elements));
}

} // namespace worldmaking
