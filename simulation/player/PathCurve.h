// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "simulation/player/CubicSpline.h"
#include "simulation/player/PathVertex.h"
#include "simulation/scenario/Trajectory.h"

namespace simulation
{

/// A point on a path. Frame: the scene's. Units: metres, radians; tangent and bend per unit of the parameter.
struct PathPoint
{
    glm::dvec3 position{0.0};
    glm::dvec3 tangent{0.0};
    glm::dvec3 bend{0.0};             ///< second derivative
    std::optional<double> headingRad; ///< missing where the path stands still
    std::optional<double> pitchRad;   ///< given by the vertices
    std::optional<double> rollRad;

    /// The curvature of the path seen from above; positive to the left. Units: 1/m.
    double planCurvature() const;
};

/// A polyline as a curve, which passes through each vertex exactly at its parameter:
/// - `position`: straight between vertices. Headings given by the vertices are reached in the middle of the
///   segment that the vertex begins, and turn evenly from middle to middle; without them the heading is that
///   of the segment, and turns within 2 m before and after each corner (esmini does the same);
/// - `follow`: the natural cubic spline through the vertices, so that speed, bank and pitch do not jump.
///   Headings are the spline through those of the vertices, or those of the curve when a vertex has none.
/// - `straight`: straight between vertices; headings given by the vertices turn evenly from vertex to vertex.
/// Pitch and roll are interpolated when every vertex gives one, else absent. A closed curve returns from its
/// last vertex to its first and repeats; its parameter wraps.
/// Source: ASAM, *OpenSCENARIO XML* 1.3, FollowTrajectoryAction and FollowingMode.
class PathCurve
{
public:
    /// `vertices`: at least two, parameters strictly increasing. A closed curve needs `closingLength`, the
    /// parameter from the last vertex back to the first.
    /// `inPlan`: distances are seen from above.
    PathCurve(std::vector<PathVertex> vertices, FollowingMode mode, std::optional<double> closingLength,
              bool inPlan = false);

    PathPoint at(double parameter) const;

    double begin() const { return _begin; }
    double end() const { return _end; }
    bool isClosed() const { return _closed; }

    /// Converts a parameter to the distance along the curve from its start, and back. Units: metres. Closed
    /// curves: one round.
    double distanceAt(double parameter) const;
    double parameterAt(double distanceM) const;
    double lengthM() const { return _distances.back(); }

private:
    double wrapped(double parameter) const;
    void buildAngles(const std::vector<PathVertex>& vertices);
    void buildDistances();

    FollowingMode _mode;
    bool _closed;
    bool _inPlan;
    double _begin;
    double _end;
    CubicSpline _x, _y, _z;
    std::optional<CubicSpline> _heading, _pitch, _roll;
    std::vector<double> _parameters; ///< of the table of distances
    std::vector<double> _distances;
};

} // namespace simulation
