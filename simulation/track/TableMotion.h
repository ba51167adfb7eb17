// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "simulation/track/FlightTrack.h"

namespace simulation
{

/// A column of numbers. The unit is the factor to metres a second or to degrees.
struct MeasuredColumn
{
    int at = -1; ///< -1: there is none
    double unit = 1.0;
    bool hasUnit = false; ///< its name tells it
};

/// The columns of a table of positions that tell how something moved: speed over ground and attitude.
///
/// **Speeds** are no part of a trajectory, which follows the fixes: they give a table without times its
/// times, and are else compared with the way. **Attitudes** are read where there is `yaw`, or `heading`
/// beside `pitch` or `roll`; `heading` alone, `course` and `track` are directions of the way, which are
/// compared with it. Names may have a unit (`speed (km/h)`, `roll_rad`) and words such as `gps`, `ground`,
/// `true`; any other word (`wind`, `rate`, `gimbal`) makes another thing of them.
class TableMotion
{
public:
    /// `names`: of the columns.
    explicit TableMotion(const std::vector<std::string>& names);

    /// Takes what a row tells of the motion into its fix. What is no number is passed over.
    void take(const std::vector<std::string>& cells, bool isDecimalComma, TrackFix& fix) const;

    /// Settles a track whose fixes are all there: gives it times where it has none, and every fix an attitude
    /// or none. Returns what is to be told. Cost: linear, and sorting of what is compared.
    std::vector<std::string> settle(FlightTrack& track) const;

private:
    void settleAttitudes(FlightTrack& track, std::vector<std::string>& notes) const;
    void timeBySpeeds(FlightTrack& track, std::vector<std::string>& notes) const;
    void compareSpeeds(const FlightTrack& track, std::vector<std::string>& notes) const;
    const std::string& nameOf(const MeasuredColumn& column) const
    {
        return _names[static_cast<std::size_t>(column.at)];
    }

    std::vector<std::string> _names;
    MeasuredColumn _speed, _yaw, _pitch, _roll;
    bool _isCourse = false;   ///< the yaw is a direction of the way
    bool _isMagnetic = false; ///< it counts from magnetic north
};

} // namespace simulation
