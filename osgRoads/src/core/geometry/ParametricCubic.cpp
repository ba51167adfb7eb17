// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 9.7 (paramPoly3), and 1.4, 5.3.4.1.4 (poly3).
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include <osgRoads/core/geometry/GaussLegendre.h>
#include <osgRoads/core/geometry/ParametricCubic.h>

namespace osgRoads::core
{

namespace
{

constexpr int kMostNewtonSteps = 20;
constexpr double kLastStep = 1e-7;    ///< of the parameter, as a share of the whole
constexpr double kStandstill = 1e-12; ///< below this speed a curve has no direction of its own

} // namespace

ParametricCubic::ParametricCubic(const CurveCoefficients& u, const CurveCoefficients& v, double length,
                                 double pEnd)
    : _u(u), _v(v), _length(length), _pEnd(pEnd)
{
}

ParametricCubic ParametricCubic::normalized(const CurveCoefficients& u, const CurveCoefficients& v,
                                            double length)
{
    ParametricCubic curve(u, v, length, 1.0);
    curve.tabulate();
    return curve;
}

ParametricCubic ParametricCubic::byArcLength(const CurveCoefficients& u, const CurveCoefficients& v,
                                             double length)
{
    ParametricCubic curve(u, v, length, length);
    curve._isByArcLength = true;
    double sum = 0.0;
    for (std::size_t i = 0; i < kPanels; ++i)
        sum += curve.lengthBetween(length * static_cast<double>(i) / kPanels,
                                   length * static_cast<double>(i + 1) / kPanels);
    curve.setLengthRatio(sum);
    return curve;
}

/// The curve is at least as long as its u: Newton's method begins at u = length, which is beyond the end.
ParametricCubic ParametricCubic::function(const CurveCoefficients& v, double length)
{
    ParametricCubic curve({0.0, 1.0, 0.0, 0.0}, v, length, length);
    curve.tabulate();
    for (int step = 0; step < kMostNewtonSteps; ++step)
    {
        const double excess = curve._lengths[kPanels] - length;
        if (!(std::fabs(excess) > 1e-12 * length)) break;
        const double shortened = curve._pEnd - excess / curve.speed(curve._pEnd);
        curve._pEnd = std::clamp(shortened, 0.1 * curve._pEnd, length);
        curve.tabulate();
    }
    return curve;
}

PlanPoint ParametricCubic::at(double s) const
{
    return pointAt(parameterAt(s));
}

PlanPoint ParametricCubic::pointAt(double p) const
{
    glm::dvec2 velocity(_u.first(p), _v.first(p));
    const glm::dvec2 acceleration(_u.second(p), _v.second(p));
    const double speedHere = std::hypot(velocity.x, velocity.y);
    PlanPoint point{positionAt(p)};
    if (speedHere > kStandstill)
        point.curvature =
            (velocity.x * acceleration.y - velocity.y * acceleration.x) / (speedHere * speedHere * speedHere);
    else
        velocity = acceleration; // the direction in which the curve leaves
    point.headingRad = std::atan2(velocity.y, velocity.x);
    return point;
}

double ParametricCubic::parameterAt(double s) const
{
    if (_isByArcLength) return s;
    const double wanted = s * _lengthRatio;
    if (wanted <= 0.0 || wanted >= _lengths[kPanels]) // beyond the ends at the speed of the end
        return wanted <= 0.0 ? wanted / std::max(speed(0.0), kStandstill)
                             : _pEnd + (wanted - _lengths[kPanels]) / std::max(speed(_pEnd), kStandstill);
    const std::size_t panel = panelOf(wanted);
    const double width = _pEnd / kPanels, from = width * static_cast<double>(panel);
    double p = tabulatedParameter(wanted);
    for (int step = 0; step < kMostNewtonSteps; ++step)
    {
        const double change =
            (_lengths[panel] + lengthBetween(from, p) - wanted) / std::max(speed(p), kStandstill);
        p = std::clamp(p - change, from, from + width);
        if (!(std::fabs(change) > kLastStep * _pEnd)) break; // the next one would be its square
    }
    return p;
}

double ParametricCubic::lengthAt(double p) const
{
    if (_isByArcLength) return p;
    if (p <= 0.0) return p * speed(0.0) / _lengthRatio;
    if (p >= _pEnd) return (_lengths[kPanels] + (p - _pEnd) * speed(_pEnd)) / _lengthRatio;
    const double width = _pEnd / kPanels;
    const auto panel = std::min(static_cast<std::size_t>(p / width), kPanels - 1);
    return (_lengths[panel] + lengthBetween(width * static_cast<double>(panel), p)) / _lengthRatio;
}

double ParametricCubic::nearestParameter(glm::dvec2 local, double guess) const
{
    double p = _isByArcLength ? guess : tabulatedParameter(guess * _lengthRatio);
    for (int step = 0; step < kMostNewtonSteps; ++step)
    {
        const glm::dvec2 away = local - positionAt(p);
        const glm::dvec2 velocity(_u.first(p), _v.first(p)), acceleration(_u.second(p), _v.second(p));
        const double square = std::max(glm::dot(velocity, velocity), kStandstill);
        // Beyond the centre of curvature the second derivative of the distance is no guide.
        const double slope = square - glm::dot(away, acceleration);
        const double change =
            std::clamp(glm::dot(away, velocity) / std::max(slope, 0.1 * square), -_pEnd, _pEnd);
        const double next = std::clamp(p + change, -0.1 * _pEnd, 1.1 * _pEnd);
        const double moved = std::fabs(next - p); // 0 where the foot lies beyond an end
        p = next;
        const bool isNewton = slope > 0.1 * square;
        if (!(moved > (isNewton ? kLastStep : 1e-3 * kLastStep) * _pEnd)) break;
    }
    return p;
}

/// The velocity between two parameters is a parabola within its three control vectors, and so is its
/// direction, where these lie within a half-plane.
double ParametricCubic::turnBetween(double from, double to) const
{
    const auto velocity = [this](double p) { return glm::dvec2(_u.first(p), _v.first(p)); };
    const glm::dvec2 first = velocity(from), last = velocity(to);
    const glm::dvec2 middle = 2.0 * velocity(0.5 * (from + to)) - 0.5 * (first + last);
    const auto angle = [](glm::dvec2 a, glm::dvec2 b)
    { return std::fabs(std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b))); };
    return angle(first, middle) + angle(middle, last);
}

std::size_t ParametricCubic::panelOf(double curveLength) const
{
    const auto above = std::upper_bound(_lengths.begin() + 1, _lengths.end() - 1, curveLength);
    return static_cast<std::size_t>(above - _lengths.begin()) - 1;
}

/// The parameter at a length of the curve, linear within its panel.
double ParametricCubic::tabulatedParameter(double curveLength) const
{
    const std::size_t panel = panelOf(curveLength);
    const double length = std::max(_lengths[panel + 1] - _lengths[panel], kStandstill);
    const double share = std::clamp((curveLength - _lengths[panel]) / length, 0.0, 1.0);
    return _pEnd / kPanels * (static_cast<double>(panel) + share);
}

double ParametricCubic::lengthBetween(double from, double to) const
{
    return integralOf([this](double p) { return speed(p); }, from, to);
}

void ParametricCubic::tabulate()
{
    const double width = _pEnd / kPanels;
    for (std::size_t i = 0; i < kPanels; ++i)
        _lengths[i + 1] =
            _lengths[i] + lengthBetween(width * static_cast<double>(i), width * static_cast<double>(i + 1));
    setLengthRatio(_lengths[kPanels]);
}

void ParametricCubic::setLengthRatio(double curveLength)
{
    _lengthRatio = curveLength / _length;
}

} // namespace osgRoads::core
