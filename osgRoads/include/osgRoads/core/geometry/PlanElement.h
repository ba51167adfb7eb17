// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include <osgRoads/core/geometry/Clothoid.h>
#include <osgRoads/core/geometry/ParametricCubic.h>

namespace osgRoads::core
{

struct LineShape
{
};

struct ArcShape
{
    double curvature = 0.0; ///< 1/m, positive to the left, not 0
};

/// The point of an element that is nearest to another.
struct PlanFoot
{
    double ds = 0.0; ///< metres after the start of the element
    PlanPoint point;
};

/// One piece of a reference line in the plan view: where it starts, and its shape.
/// Frame: the inertial frame of the file, x east and y north, metres. Shapes are computed relative to the
/// start, so the precision does not depend on the distance from the origin.
/// Source: ASAM OpenDRIVE 1.8, 9.2 to 9.7.
class PlanElement
{
public:
    using Shape = std::variant<LineShape, ArcShape, Clothoid, ParametricCubic>;

    PlanElement(double sIn, double lengthIn, glm::dvec2 position, double headingRad, Shape shape);

    /// Returns the point `ds` metres after the start of the element.
    PlanPoint at(double ds) const;

    /// Returns the point of the element, between `from` and `to` metres after its start, that is nearest to
    /// `position`, near `guess`. Error: 1e-9 m where the curve turns less than a quarter circle within [from,
    /// to].
    PlanFoot footOf(glm::dvec2 position, double guess, double from, double to) const;

    /// Returns the greatest distance of the curve between two distances from the start to its chord.
    double sagitta(double from, double to) const;

    const Shape& shape() const { return _shape; }

    /// The word of the file for the shape: line, arc, spiral, paramPoly3 (poly3 counts as this one).
    const char* word() const;

    double s;      ///< where the element starts, metres along the road
    double length; ///< metres

private:
    PlanPoint localAt(double ds) const;
    PlanPoint fromLocal(PlanPoint point) const;
    double nearestTo(glm::dvec2 local, double guess, double from, double to) const;

    glm::dvec2 _position, _direction; ///< start and unit vector along its heading
    double _headingRad;
    Shape _shape;
};

} // namespace osgRoads::core
