// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace simulation
{

inline constexpr double kJsbsimFootM = 0.3048;

/// What is read of JSBSim after each step. Units: feet, radians, seconds, as JSBSim has them; its Earth's and
/// local axes.
enum class JsbsimColumn
{
    time,
    earthX,
    earthY,
    earthZ,
    velocityNorth,
    velocityEast,
    velocityDown,
    roll,
    pitch,
    heading,
    rateP,
    rateQ,
    rateR,
    height,        ///< over JSBSim's sea
    last = height, ///< those above are needed, those below may be missing
    elevator,
    leftAileron,
    rightAileron,
    rudder,
    flapDeg,
    propellerRpm,
    noseWheel, ///< 1 while it touches the ground
    leftWheel,
    rightWheel,
    noseStrut, ///< pressed in
    leftStrut,
    rightStrut,
    count
};

inline constexpr std::size_t kJsbsimColumns = static_cast<std::size_t>(JsbsimColumn::count);

/// Their properties in JSBSim; the time has none.
inline constexpr std::array<std::string_view, kJsbsimColumns> kJsbsimProperties{
    "",
    "position/ecef-x-ft",
    "position/ecef-y-ft",
    "position/ecef-z-ft",
    "velocities/v-north-fps",
    "velocities/v-east-fps",
    "velocities/v-down-fps",
    "attitude/phi-rad",
    "attitude/theta-rad",
    "attitude/psi-rad",
    "velocities/p-rad_sec",
    "velocities/q-rad_sec",
    "velocities/r-rad_sec",
    "position/h-sl-ft",
    "fcs/elevator-pos-rad",
    "fcs/left-aileron-pos-rad",
    "fcs/right-aileron-pos-rad",
    "fcs/rudder-pos-rad",
    "fcs/flap-pos-deg",
    "propulsion/engine/propeller-rpm",
    "gear/unit/WOW",
    "gear/unit[1]/WOW",
    "gear/unit[2]/WOW",
    "gear/unit/compression-ft",
    "gear/unit[1]/compression-ft",
    "gear/unit[2]/compression-ft"};

/// The numbers after one step; 0 where JSBSim has no such column.
struct JsbsimRow
{
    std::array<double, kJsbsimColumns> values{};
    std::vector<std::optional<double>>
        more{}; ///< of the further properties that were asked for; nothing: the aircraft has none such

    double operator[](JsbsimColumn column) const { return values[static_cast<std::size_t>(column)]; }
    bool isFinite() const;
};

/// The columns as JSBSim has them: a property that an aircraft lacks is left out.
class JsbsimTable
{
public:
    /// Takes the line of captions; nothing: one that is needed is missing. `more`: further properties.
    static std::optional<JsbsimTable> create(std::string_view captions,
                                             const std::vector<std::string>& more = {});

    /// Reads a line of numbers; nothing: another count, or no numbers. NaN and infinite ones are numbers.
    std::optional<JsbsimRow> read(std::string_view line) const;

private:
    std::array<int, kJsbsimColumns> _places{}; ///< in a line; -1: none
    std::vector<int> _more;                    ///< the same of the further ones
    int _count = 0;
};

} // namespace simulation
