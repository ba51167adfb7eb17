// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>

#include <glm/glm.hpp>

#include "simulation/geodesy/LocalFrame.h"
#include "simulation/scenario/Position.h"
#include "simulation/state/GroundProvider.h"

namespace simulation
{

/// Where a place of the earth lies in a scene that is a map: that of a road network with a georeference.
/// Nothing: outside of it.
using MapProjection = std::function<std::optional<glm::dvec3>(const Geodetic& place)>;

/// Converts the positions of a scenario to points of the scene.
class SceneFrame
{
public:
    /// `origin` absent: a scene without a local frame; without a `projection` either, GeoPosition has no
    /// meaning there. `ground` may be empty.
    SceneFrame(const std::optional<Geodetic>& origin, GroundProvider ground, MapProjection projection = {});

    bool hasOrigin() const { return _frame.has_value(); }
    bool hasGround() const { return static_cast<bool>(_ground); }

    /// Returns false for a GeoPosition without an origin, for an unsupported position, and for coordinates
    /// beyond 1e9.
    bool canPlace(const Position& position) const;

    /// Precondition: canPlace(). Frame: the scene's.
    glm::dvec3 place(const Position& position) const;

    /// Asks the ground provider. Returns nothing outside the data and beyond 1e8 m, because providers count
    /// in samples.
    std::optional<GroundSample> groundAt(double eastM, double northM,
                                         double fromM = GroundProvider::kAnyHeightM) const;
    const std::optional<LocalFrame>& frame() const { return _frame; }

private:
    glm::dvec3 place(const WorldPosition& position) const;
    glm::dvec3 place(const GeoPosition& position) const;
    std::optional<glm::dvec3> onMap(const GeoPosition& position) const;

    std::optional<LocalFrame> _frame;
    MapProjection _projection;
    GroundProvider _ground;
};

/// Returns the orientation of a position; empty for an unsupported position.
Orientation orientationOf(const Position& position);

} // namespace simulation
