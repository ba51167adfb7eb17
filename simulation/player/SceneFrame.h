// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>

#include <glm/glm.hpp>

#include "simulation/geodesy/LocalFrame.h"
#include "simulation/scenario/Position.h"

namespace simulation
{

/// The ground at a point. Frame: the scene's.
struct GroundSample
{
    double heightM = 0.0; ///< z of the surface
};

/// Returns the ground below or above (east, north) in the scene's frame, or nothing outside the data. The same point
/// must always give the same answer.
using GroundProvider = std::function<std::optional<GroundSample>(double eastM, double northM)>;

/// Converts the positions of a scenario to points of the scene.
class SceneFrame
{
public:
    /// `origin` absent: a scene without georeference, in which GeoPosition has no meaning. `ground` may be empty.
    SceneFrame(const std::optional<Geodetic>& origin, GroundProvider ground);

    bool hasOrigin() const { return _frame.has_value(); }

    /// Returns false for a GeoPosition without an origin, for an unsupported position, and for coordinates beyond
    /// 1e9.
    bool canPlace(const Position& position) const;

    /// Precondition: canPlace(). Frame: the scene's.
    glm::dvec3 place(const Position& position) const;

    /// Returns nothing outside the data and beyond 1e8 m, because providers count in samples.
    std::optional<GroundSample> groundAt(double eastM, double northM) const;
    const std::optional<LocalFrame>& frame() const { return _frame; }

private:
    glm::dvec3 place(const WorldPosition& position) const;
    glm::dvec3 place(const GeoPosition& position) const;

    std::optional<LocalFrame> _frame;
    GroundProvider _ground;
};

/// Returns the orientation of a position; empty for an unsupported position.
Orientation orientationOf(const Position& position);

} // namespace simulation
