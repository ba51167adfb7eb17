// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "simulation/scenario/SourceLine.h"

namespace simulation
{

/// Angles as in OpenSCENARIO; a missing angle follows from the path, the road or the ground.
/// Frame: ISO 8855 about the axes of the scene. Heading counter-clockwise from east, pitch positive nose
/// down, roll positive right side down. With `isRelative` they count from the direction of the lane, or from
/// the entity that the position refers to. Units: radians, as in the file.
struct Orientation
{
    std::optional<double> headingRad;
    std::optional<double> pitchRad;
    std::optional<double> rollRad;
    bool isRelative = false;

    bool operator==(const Orientation&) const = default;
};

// Positions on the road network, and relative to entities. Units: metres. Source: ASAM OpenSCENARIO XML 1.3,
// Position.

/// A place on a lane; the offset counts to the left of the reference line.
struct LanePosition
{
    static constexpr std::string_view kElement = "LanePosition";

    SourceLine source;
    std::string roadId;
    int lane = 0;
    double sM = 0.0;
    double offsetM = 0.0;
    Orientation orientation;

    bool operator==(const LanePosition&) const = default;
};

struct RoadPosition
{
    static constexpr std::string_view kElement = "RoadPosition";

    SourceLine source;
    std::string roadId;
    double sM = 0.0;
    double tM = 0.0;
    Orientation orientation;

    bool operator==(const RoadPosition&) const = default;
};

/// A place on a lane that is counted from the lane of an entity.
struct RelativeLanePosition
{
    static constexpr std::string_view kElement = "RelativeLanePosition";

    SourceLine source;
    std::string entity;
    int lanes = 0;
    double dsM = 0.0;         ///< along the road, in the direction in which the entity looks
    bool isAlongLane = false; ///< dsLane: in the direction of the entity's lane instead
    double offsetM = 0.0;
    Orientation orientation;

    bool operator==(const RelativeLanePosition&) const = default;
};

struct RelativeRoadPosition
{
    static constexpr std::string_view kElement = "RelativeRoadPosition";

    SourceLine source;
    std::string entity;
    double dsM = 0.0;
    double dtM = 0.0;
    Orientation orientation;

    bool operator==(const RelativeRoadPosition&) const = default;
};

/// In the frame of an entity: x forward, y left, z up.
struct RelativeObjectPosition
{
    static constexpr std::string_view kElement = "RelativeObjectPosition";

    SourceLine source;
    std::string entity;
    double dxM = 0.0, dyM = 0.0, dzM = 0.0;
    Orientation orientation;

    bool operator==(const RelativeObjectPosition&) const = default;
};

/// In the axes of the scene, from an entity.
struct RelativeWorldPosition
{
    static constexpr std::string_view kElement = "RelativeWorldPosition";

    SourceLine source;
    std::string entity;
    double dxM = 0.0, dyM = 0.0, dzM = 0.0;
    Orientation orientation;

    bool operator==(const RelativeWorldPosition&) const = default;
};

} // namespace simulation
