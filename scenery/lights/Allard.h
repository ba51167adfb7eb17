// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace scenery
{

/// Returns the illuminance at an eye by a point light, in lux: E = I exp(-3 d/V) / d². `visibilityM`: the
/// distance at which 5 % of a contrast remain.
/// Source: Allard, *Mémoire sur l'intensité et la portée des phares* (1876); ICAO, *Doc 9328*, 3.
double illuminanceLx(double candela, double distanceM, double visibilityM);

/// Returns the least illuminance that an eye sees before a background, in lux. It rises without a jump: 8e-7
/// up to 2 foot-lamberts (6.85 cd/m²), 1e-5, 1e-4 and 1e-3 at the geometric middles of the classes
/// intermediate and day, and at bright day's.
/// Source: ICAO, *Annex 3*, attachment D: a table of four classes with jumps, which we join by straight lines
/// between logarithms.
double leastIlluminanceLx(double backgroundCdM2);

/// Returns the luminance of the sky at the horizon, in cd/m², for the height of the sun; clear, or overcast
/// (`cloudCover` 1). Source: illuminances of level ground by Bond and Henderson, *The conspicuity of
/// flags …* (1963), over π.
double backgroundCdM2(double sunElevationDeg, double cloudCover);

/// Returns the distance in metres within which a light is seen.
double visibleRangeM(double candela, double visibilityM, double leastLx);

} // namespace scenery
