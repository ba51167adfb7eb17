// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <osgRoads/core/network/RoadItem.h>

namespace osgRoads::core
{

/// A traffic light or sign; (s, t) is on the road that it holds for.
/// Source: ASAM OpenDRIVE 1.8, 14 (signals).
struct Signal : RoadItem
{
    /// Where the post stands, when that is not at (s, t): on a road, or at x, y of the inertial frame.
    struct Post
    {
        bool isOnRoad = false;
        std::string roadId;
        double s = 0.0, t = 0.0; ///< or x and y
        double z = 0.0;          ///< above the road, or in the inertial frame
        double headingRad = 0.0, pitchRad = 0.0, rollRad = 0.0;
    };

    struct Dependency
    {
        std::string id, type;
    };

    std::string country, countryRevision, unit, text;
    std::optional<double> value;
    std::vector<Dependency> dependencies, references;
    std::optional<Post> post;
};

/// A signal of another road that holds for this one, too.
struct SignalReference
{
    std::string id; ///< of the signal
    double s = 0.0, t = 0.0;
    char orientation = '0';
    std::vector<LaneValidity> validities;
    int line = 0;
};

/// Signals that are switched together.
struct Controller
{
    struct Control
    {
        std::string signalId, type;
    };

    std::string id, name;
    int sequence = 0;
    std::vector<Control> controls;
    int line = 0;
};

} // namespace osgRoads::core
