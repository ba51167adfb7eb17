// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
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
    std::vector<Vertex> vertices;    ///< two at least
    std::optional<double> lengthM{}; ///< of the curve that it stands for; nothing: that of its lines

    bool operator==(const Polyline&) const = default;
};

/// A curve whose curvature changes evenly over its length. Units: metres, seconds, 1/m.
struct Clothoid
{
    static constexpr std::string_view kElement = "Clothoid";

    SourceLine source;
    double curvature = 0.0;      ///< at the start, positive to the left
    double curvaturePrime = 0.0; ///< per metre; 1.0: curvatureDot
    double lengthM = 0.0;
    std::optional<double> startTimeS, stopTimeS;
    Position start;

    bool operator==(const Clothoid&) const = default;
};

/// Clothoids one after the other.
struct ClothoidSpline
{
    static constexpr std::string_view kElement = "ClothoidSpline";

    struct Segment
    {
        double curvatureStart = 0.0, curvatureEnd = 0.0;
        double lengthM = 0.0;
        double headingOffsetRad = 0.0; ///< turns the direction at the start
        std::optional<double> timeStartS;
        std::optional<Position>
            start; ///< nothing: where the one before ends; of the first one, where the entity is

        bool operator==(const Segment&) const = default;
    };

    SourceLine source;
    std::vector<Segment> segments;
    std::optional<double> timeEndS;

    bool operator==(const ClothoidSpline&) const = default;
};

/// A non-uniform rational B-spline.
struct Nurbs
{
    static constexpr std::string_view kElement = "Nurbs";

    struct ControlPoint
    {
        std::optional<double> timeS;
        double weight = 1.0;
        Position position;

        bool operator==(const ControlPoint&) const = default;
    };

    SourceLine source;
    int order = 2; ///< degree plus one
    std::vector<ControlPoint> points;
    std::vector<double> knots; ///< never falling; as many as points plus order

    bool operator==(const Nurbs&) const = default;
};

using TrajectoryShape = std::variant<Polyline, Clothoid, ClothoidSpline, Nurbs, Unsupported>;

/// A flight that somebody recorded, in a file beside the scenario.
struct Recording
{
    std::string file;  ///< as the scenario names it
    std::string track; ///< its name in the file; empty: the first that moves

    bool operator==(const Recording&) const = default;
};

/// Returns whether a file is one of recorded tracks by its name (.igc, .gpx, .kml, .kmz, .acmi, .csv, in
/// small or capital letters), with .gz after it or without.
bool namesTrackFile(const std::filesystem::path& file);

struct Trajectory
{
    SourceLine source;
    std::string name;
    bool closed = false; ///< the last vertex is joined to the first, and the path repeats
    TrajectoryShape shape;
    std::optional<Recording> recording{}; ///< where the shape comes from; layRecordings() fills it

    bool operator==(const Trajectory&) const = default;
};

/// Converts the times of the vertices to those of the simulation: t = offset + scale·vertex, counted from the
/// start of the action (relative) or of the simulation (absolute).
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
    /// no word of the language: `follow` on road networks, where esmini keeps to the straight lines and turns
    /// evenly
    straight,
};

} // namespace simulation
