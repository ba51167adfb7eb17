// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/flight/TerrainGuard.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <foundation/Angle.h>

namespace simulation
{
namespace
{

constexpr double kEveryS = 0.5;
constexpr double kClearM = 60.0;       ///< above the ground ahead
constexpr double kRisesM = 15.0;       ///< ahead above the ground below, from where on it matters
constexpr double kNextM = 150.0;       ///< between two looks
constexpr std::size_t kLooks = 20;     ///< 3 km
constexpr double kGradient = 0.05;     ///< that a light aircraft climbs at full power
constexpr double kSeenAheadM = 1500.0; ///< within which a climb begins
constexpr std::array<double, 12> kAsideDeg{20.0, -20.0, 40.0,  -40.0,  60.0,  -60.0,
                                           90.0, -90.0, 120.0, -120.0, 150.0, 180.0};

/// The ground along a track.
struct Profile
{
    double highestM = -1e9; ///< within kSeenAheadM
    double marginM = 1e9;   ///< the least that a climb would clear it by, beyond kClearM
};

Profile profileAlong(const FlightSense& sense, const Ground& ground, double track)
{
    const glm::dvec3 along(std::sin(track), std::cos(track), 0.0);
    std::array<glm::dvec3, kLooks> places;
    std::array<GroundPoint, kLooks> answers;
    for (std::size_t i = 0; i < kLooks; ++i)
        places[i] = sense.position + kNextM * static_cast<double>(i + 1) * along;
    ground.heightsBelow(places, answers);
    Profile profile;
    for (std::size_t i = 0; i < kLooks; ++i)
    {
        if (!answers[i].isKnown) continue;
        const double wayM = kNextM * static_cast<double>(i + 1);
        if (wayM <= kSeenAheadM) profile.highestM = std::max(profile.highestM, answers[i].heightM);
        profile.marginM =
            std::min(profile.marginM, sense.position.z + kGradient * wayM - answers[i].heightM - kClearM);
    }
    return profile;
}

} // namespace

const TerrainAdvice& TerrainGuard::look(const FlightSense& sense, const Ground& ground, double timeS)
{
    if (timeS < _lookedS + kEveryS) return _advice;
    _lookedS = timeS;
    const double belowM = sense.position.z - sense.wheelHeightM;
    const Profile ahead = profileAlong(sense, ground, sense.track);
    const bool wasTurning = _advice.track.has_value();
    _advice = {};
    if (ahead.highestM > belowM + kRisesM || wasTurning)
    {
        _advice.leastM = ahead.highestM + kClearM;
        _advice.isClimbing = sense.position.z < _advice.leastM;
    }
    if (ahead.marginM >= 0.0) return _advice;
    double best = ahead.marginM, track = sense.track;
    for (const double asideDeg : kAsideDeg)
    {
        const double aside = sense.track + foundation::radiansOf(asideDeg);
        const double margin = profileAlong(sense, ground, aside).marginM;
        if (margin > best)
        {
            best = margin;
            track = aside;
        }
        if (margin >= 0.0) break;
    }
    _advice.track = track;
    _advice.isClimbing = true;
    return _advice;
}

} // namespace simulation
