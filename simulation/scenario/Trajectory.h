// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "simulation/scenario/Position.h"

namespace simulation
{

struct Vertex
{
    SourceLine source;
    std::optional<double> timeS;
    Position position;

    /// Returns whether the time of a vertex is at least a microsecond after the one before.
    static bool isLater(double before, double time) { return time - before >= 1e-6; }

    bool operator==(const Vertex&) const = default;
};

struct Polyline
{
    SourceLine source;
    std::vector<Vertex> vertices; ///< two at least

    bool operator==(const Polyline&) const = default;
};

using TrajectoryShape = std::variant<Polyline, Unsupported>;

struct Trajectory
{
    SourceLine source;
    std::string name;
    bool closed = false; ///< the last vertex is joined to the first, and the path repeats
    TrajectoryShape shape;

    bool operator==(const Trajectory&) const = default;
};

/// Converts the times of the vertices to those of the simulation: t = offset + scale·vertex, counted from the start
/// of the action (relative) or of the simulation (absolute).
struct Timing
{
    enum class Domain
    {
        absolute,
        relative,
    };

    Domain domain = Domain::relative;
    double scale = 1.0;
    double offsetS = 0.0;

    static bool isScale(double scale) { return scale >= 1e-6 && scale <= 1e6; }

    bool operator==(const Timing&) const = default;
};

enum class FollowingMode
{
    position,
    follow,
    straight, ///< no word of the language: `follow` on road networks, where esmini keeps to the straight lines and turns evenly
};

} // namespace simulation
