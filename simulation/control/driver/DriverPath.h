// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace simulation
{

/// A place on the way of a driver, and the speed that is allowed there. Frame: the scene's.
struct DriverPoint
{
    glm::dvec3 place{0.0};
    double limitMps = 1e9;
};

/// A line on the way where a driver may have to stop.
struct DriverStop
{
    double atM = 0.0;   ///< along the way
    std::string signal; ///< id of the traffic light; empty: a stop sign
};

/// The way of a driver: the middle of a lane, or any path, as points at most some metres apart, with its
/// stops.
class DriverPath
{
public:
    /// `points`: two at least, none twice.
    explicit DriverPath(const std::vector<DriverPoint>& points, std::vector<DriverStop> stops = {});

    /// Where something is beside the way.
    struct Beside
    {
        double alongM = 0.0;
        double offsetM = 0.0; ///< to the left
    };

    /// The nearest place of the way; within `reachM` before and after `aboutM`.
    Beside nearest(const glm::dvec3& place, double aboutM, double reachM) const;

    glm::dvec3 placeAt(double alongM, double offsetM = 0.0) const;
    double limitAt(double alongM) const { return _points[indexAt(alongM)].limitMps; }
    double headingRadAt(double alongM) const;

    /// Positive to the left, over some metres. Units: 1/m.
    double curvatureAt(double alongM) const { return _curvature[indexAt(alongM)]; }

    double lengthM() const { return _along.back(); }
    const std::vector<DriverStop>& stops() const { return _stops; }

private:
    std::size_t indexAt(double alongM) const;

    std::vector<DriverPoint> _points;
    std::vector<double> _along, _curvature;
    std::vector<DriverStop> _stops;
};

} // namespace simulation
