// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include <glm/geometric.hpp>

#include <osgRoads/core/geometry/PlanPoint.h>

namespace osgRoads::core
{

/// The coefficients of one coordinate of a cubic curve: a + b·p + c·p² + d·p³.
struct CurveCoefficients
{
    double a = 0.0, b = 0.0, c = 0.0, d = 0.0;

    double value(double p) const { return a + p * (b + p * (c + p * d)); }
    double first(double p) const { return b + p * (2.0 * c + p * 3.0 * d); }
    double second(double p) const { return 2.0 * c + 6.0 * d * p; }
};

/// A cubic curve (u(p), v(p)) in the frame of a plan-view element, asked for by arc length.
/// The parameter at an arc length is found by Newton's method on the length, which Gauss–Legendre quadrature
/// gives, from a table of kPanels lengths. When the curve is not as long as its element says, arc lengths are
/// scaled to fit.
/// Source: ASAM OpenDRIVE 1.8, 9.7 (paramPoly3), and 1.4, 5.3.4.1.4 (poly3).
/// Differs: with pRange arcLength, p is the arc length as the file has it, even when the curve disagrees.
class ParametricCubic
{
public:
    /// paramPoly3 with pRange normalized: p runs from 0 to 1 along `length` metres.
    static ParametricCubic normalized(const CurveCoefficients& u, const CurveCoefficients& v, double length);

    /// paramPoly3 with pRange arcLength: p is the distance along the curve.
    static ParametricCubic byArcLength(const CurveCoefficients& u, const CurveCoefficients& v, double length);

    /// poly3: v as a function of u, up to the u at which the curve is `length` metres long.
    static ParametricCubic function(const CurveCoefficients& v, double length);

    /// Returns the point at arc length s.
    PlanPoint at(double s) const;

    /// Returns the parameter at arc length s.
    double parameterAt(double s) const;

    /// Returns the arc length at a parameter: the inverse of parameterAt().
    double lengthAt(double p) const;

    /// Returns the parameter at which the curve is nearest to `local`, by Newton's method from the arc length
    /// `guess`. It may lie a little beyond the ends.
    double nearestParameter(glm::dvec2 local, double guess) const;

    /// Returns a bound on the angle between the tangents of any two points of the curve between two
    /// parameters, radians.
    double turnBetween(double from, double to) const;

    /// Returns the point at a parameter.
    PlanPoint pointAt(double p) const;
    glm::dvec2 positionAt(double p) const { return {_u.value(p), _v.value(p)}; }

    /// The length of the curve divided by the length of its element: 1 in a sound file.
    double lengthRatio() const { return _lengthRatio; }

    bool isByArcLength() const { return _isByArcLength; }
    const CurveCoefficients& u() const { return _u; }
    const CurveCoefficients& v() const { return _v; }

private:
    ParametricCubic(const CurveCoefficients& u, const CurveCoefficients& v, double length, double pEnd);
    double speed(double p) const { return glm::length(glm::dvec2(_u.first(p), _v.first(p))); }
    double lengthBetween(double from, double to) const;
    std::size_t panelOf(double curveLength) const;
    double tabulatedParameter(double curveLength) const;
    void tabulate();
    void setLengthRatio(double curveLength);

    static constexpr std::size_t kPanels = 16;

    CurveCoefficients _u, _v;
    double _length, _pEnd, _lengthRatio = 1.0;
    bool _isByArcLength = false;
    std::array<double, kPanels + 1> _lengths{}; ///< of the curve from its start to each panel's end
};

} // namespace osgRoads::core
