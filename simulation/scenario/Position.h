// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "simulation/scenario/RoadPositions.h"
#include "simulation/scenario/SourceLine.h"

namespace simulation
{

/// Frame: east-north-up about the scene's origin. Units: metres.
/// A missing z means: on the ground, where the player knows one, else 0.
struct WorldPosition
{
    SourceLine source;
    double xM = 0.0;
    double yM = 0.0;
    std::optional<double> zM;
    Orientation orientation;

    bool operator==(const WorldPosition&) const = default;
};

/// WGS84. The file's `latitude` and `longitude` (1.1) are radians, `latitudeDeg` and `longitudeDeg` (1.2)
/// degrees; the model keeps degrees.
/// `height` (1.0, 1.1; deprecated from 1.2 on) is "above a reference surface (e.g. sea level, earth
/// surface)", here the ellipsoid; `altitude` (from 1.2 on) is above the road surface, here the ground.
/// Neither: on the ground. Source: ASAM OpenSCENARIO XML 1.1 and 1.3, class GeoPosition.
struct GeoPosition
{
    SourceLine source;
    double latitudeDeg = 0.0;
    double longitudeDeg = 0.0;
    std::optional<double> heightM;   ///< above the ellipsoid
    std::optional<double> altitudeM; ///< above the ground; heightM wins where both stand
    Orientation orientation;         ///< about the scene's axes, as for WorldPosition

    bool operator==(const GeoPosition&) const = default;
};

/// A position that refers to nothing that moves.
using FixedPosition = std::variant<WorldPosition, GeoPosition, LanePosition, RoadPosition, Unsupported>;

/// How the way from one waypoint to the next is chosen.
enum class RouteStrategy
{
    shortest,
    fastest, ///< by the speed limits
    leastIntersections,
    random,
};

/// Places that are driven over one after the other.
struct Route
{
    SourceLine source;
    std::string name;
    bool closed = false;
    std::vector<FixedPosition> waypoints;
    std::vector<RouteStrategy> strategies; ///< of the way to each waypoint; shorter: shortest

    bool operator==(const Route&) const = default;
};

/// A place on a route, so far from its first waypoint. `lane` absent: the lane of the route, and the offset
/// from its middle.
struct RoutePosition
{
    static constexpr std::string_view kElement = "RoutePosition";

    SourceLine source;
    Route route;
    std::string entity; ///< not empty: where this entity is (FromCurrentEntity), whatever the path says
    double pathM = 0.0;
    std::optional<int> lane;
    double offsetM = 0.0;
    Orientation orientation;

    bool operator==(const RoutePosition&) const = default;
};

struct Trajectory;

/// A place so far along a trajectory, and beside it.
struct TrajectoryPosition
{
    static constexpr std::string_view kElement = "TrajectoryPosition";

    SourceLine source;
    std::shared_ptr<const Trajectory> trajectory; ///< never null
    double sM = 0.0;
    double tM = 0.0; ///< to the left
    Orientation orientation;

    bool operator==(const TrajectoryPosition& other) const;
};

using PositionKinds = std::variant<WorldPosition, GeoPosition, LanePosition, RoadPosition,
                                   RelativeLanePosition, RelativeRoadPosition, RelativeObjectPosition,
                                   RelativeWorldPosition, RoutePosition, TrajectoryPosition, Unsupported>;

/// A place. Its copying, comparing and destroying are compiled once, in Position.cpp: each unit that reads
/// this header would pay for them.
struct Position : PositionKinds
{
    using PositionKinds::variant;

    Position();
    Position(const Position&);
    Position(Position&&) noexcept;
    Position& operator=(const Position&);
    Position& operator=(Position&&) noexcept;
    ~Position();

    bool operator==(const Position&) const;
};

} // namespace simulation
