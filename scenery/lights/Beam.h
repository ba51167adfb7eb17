// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace scenery
{

/// A place of a curve: the share of a lamp's intensity at an angle.
struct BeamPoint
{
    double deg = 0.0, share = 1.0;
};

/// How a lamp spreads its light: the share of its intensity at an angle aside of its axis times that at an
/// angle above its axis. Curves are straight between their points and go on level beyond the last ones.
struct Beam
{
    std::span<const BeamPoint> aside; ///< -180…180 degrees, counter-clockwise seen from above
    std::span<const BeamPoint> up;    ///< -90…90 degrees
};

/// The beams that lamps have.
enum class BeamKind
{
    everywhere,
    above,         ///< as low lamps shine: nothing below the horizon
    runwayEdge,    ///< of high intensity, one direction
    approach,      ///< the same, wider
    inset,         ///< of centre lines and touchdown zones, narrow
    threshold,     ///< a green or red one, one direction
    papi,          ///< narrow above and below, 15 degrees to each side
    streetLamp,    ///< downwards and aside; little upwards
    window,        ///< of a wall: one half of what is around
    forwardLeft,   ///< position lamp of an aircraft: ahead to 110 degrees to the left
    forwardRight,  ///< the same to the right
    rear,          ///< position lamp: 70 degrees to both sides of the tail
    anticollision, ///< all around, 30 degrees above and below in full
    landing,       ///< a narrow beam ahead
    lowBeam,       ///< head lamps of a car
    carRear,       ///< tail, brake and other lamps of a car, 80 degrees to both sides
};
inline constexpr int kBeamKinds = static_cast<int>(BeamKind::carRear) + 1;

/// Returns a beam. Sources: ICAO, *Annex 14*, volume I, appendix 2 (runways, approach, PAPI), with ellipses
/// as products of two curves; 14 CFR 23.1389 to 23.1395 and 23.1401 (aircraft); the others were chosen.
const Beam& beamOf(BeamKind kind);

/// Returns the share, 0…1, at angles in degrees. Angles aside need not be within ±180.
double shareOf(const Beam& beam, double asideDeg, double upDeg);

} // namespace scenery
