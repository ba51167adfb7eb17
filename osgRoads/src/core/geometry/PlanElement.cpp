// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 9.2 to 9.7.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <foundation/NearestOnSegment.h>
#include <glm/geometric.hpp>

#include <osgRoads/core/geometry/PlanElement.h>

namespace osgRoads::core
{

namespace
{

constexpr int kMostSteps = 12;
constexpr double kNewtonStepM = 1e-5; ///< a smaller step ends Newton's method: the next would be its square
constexpr double kStepM = 1e-9;       ///< likewise where the method is only linear

PlanPoint arcPoint(double curvature, double ds)
{
    const double turn = curvature * ds;
    const double half = 0.5 * turn;
    // The chord has the length ds·sin(half)/half and the heading half: exact for small turns, too.
    const double chord = std::fabs(half) < 1e-9 ? ds : ds * std::sin(half) / half;
    return {glm::dvec2(chord * std::cos(half), chord * std::sin(half)), turn, curvature};
}

/// Returns the arc length of the point of a circle that is nearest to `local`; of all turns the one nearest
/// to `guess`.
double nearestOnArc(glm::dvec2 local, double curvature, double guess)
{
    const double radius = 1.0 / curvature; // signed
    const double sign = curvature > 0.0 ? 1.0 : -1.0;
    const double ds = radius * std::atan2(sign * local.x, sign * (radius - local.y));
    const double circle = 2.0 * std::numbers::pi * std::fabs(radius);
    return ds + circle * std::round((guess - ds) / circle);
}

} // namespace

PlanElement::PlanElement(double sIn, double lengthIn, glm::dvec2 position, double headingRad, Shape shape)
    : s(sIn),
      length(lengthIn),
      _position(position),
      _direction(std::cos(headingRad), std::sin(headingRad)),
      _headingRad(headingRad),
      _shape(std::move(shape))
{
}

PlanPoint PlanElement::localAt(double ds) const
{
    switch (_shape.index())
    {
    case 1:
        return arcPoint(std::get<1>(_shape).curvature, ds);
    case 2:
        return std::get<2>(_shape).at(ds);
    case 3:
        return std::get<3>(_shape).at(ds);
    default:
        return {glm::dvec2(ds, 0.0), 0.0, 0.0};
    }
}

PlanPoint PlanElement::at(double ds) const
{
    return fromLocal(localAt(ds));
}

PlanPoint PlanElement::fromLocal(PlanPoint point) const
{
    const glm::dvec2 local = point.position;
    point.position = _position + glm::dvec2(local.x * _direction.x - local.y * _direction.y,
                                            local.x * _direction.y + local.y * _direction.x);
    point.headingRad += _headingRad;
    return point;
}

PlanFoot PlanElement::footOf(glm::dvec2 position, double guess, double from, double to) const
{
    const glm::dvec2 offset = position - _position;
    const glm::dvec2 local(glm::dot(offset, _direction), offset.y * _direction.x - offset.x * _direction.y);
    if (const auto* cubic = std::get_if<ParametricCubic>(&_shape))
    {
        const double p = cubic->nearestParameter(local, guess), ds = cubic->lengthAt(p);
        if (ds >= from && ds <= to) return {ds, fromLocal(cubic->pointAt(p))};
        return {std::clamp(ds, from, to), at(std::clamp(ds, from, to))};
    }
    const double ds = nearestTo(local, guess, from, to);
    return {ds, at(ds)};
}

double PlanElement::nearestTo(glm::dvec2 local, double guess, double from, double to) const
{
    if (std::holds_alternative<LineShape>(_shape)) return std::clamp(local.x, from, to);
    if (const auto* arc = std::get_if<ArcShape>(&_shape))
        return std::clamp(nearestOnArc(local, arc->curvature, guess), from, to);
    double ds = std::clamp(guess, from, to);
    for (int step = 0; step < kMostSteps; ++step)
    {
        const PlanPoint point = localAt(ds);
        const glm::dvec2 tangent = point.tangent(), away = local - point.position;
        const double along = glm::dot(away, tangent);
        const double left = away.y * tangent.x - away.x * tangent.y;
        // The foot moves 1/(1 - κ·t) as fast as the point; beyond the centre of curvature that is no guide.
        const double slope = 1.0 - point.curvature * left;
        const double next = std::clamp(ds + along / std::max(slope, 0.1), from, to);
        const bool isReached = !(std::fabs(next - ds) > (slope > 0.1 ? kNewtonStepM : kStepM));
        ds = next;
        if (isReached) break;
    }
    return ds;
}

double PlanElement::sagitta(double from, double to) const
{
    if (std::holds_alternative<LineShape>(_shape)) return 0.0;
    const double span = to - from;
    if (std::holds_alternative<ParametricCubic>(_shape))
    {
        // A cubic lies within its control points, which are 4/3 as far from the chord as the curve at most.
        const auto& curve = std::get<ParametricCubic>(_shape);
        const double p0 = curve.parameterAt(from), p3 = curve.parameterAt(to), third = (p3 - p0) / 3.0;
        const glm::dvec2 start = curve.positionAt(p0), end = curve.positionAt(p3);
        const glm::dvec2 inner[2] = {start + third * glm::dvec2(curve.u().first(p0), curve.v().first(p0)),
                                     end - third * glm::dvec2(curve.u().first(p3), curve.v().first(p3))};
        double farthest = 0.0;
        for (const glm::dvec2& control : inner)
        {
            const double along = foundation::nearestShare(control, start, end);
            farthest = std::max(farthest, glm::length(control - start - along * (end - start)));
        }
        return farthest;
    }
    double sharpest = 0.0;
    if (const auto* arc = std::get_if<ArcShape>(&_shape)) sharpest = std::fabs(arc->curvature);
    if (const auto* spiral = std::get_if<Clothoid>(&_shape))
        sharpest = std::max(std::fabs(spiral->curvatureAt(from)), std::fabs(spiral->curvatureAt(to)));
    return std::min(0.125 * sharpest * span * span, span);
}

const char* PlanElement::word() const
{
    constexpr const char* kWords[] = {"line", "arc", "spiral", "paramPoly3"};
    return kWords[_shape.index()];
}

} // namespace osgRoads::core
