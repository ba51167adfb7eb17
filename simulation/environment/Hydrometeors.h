// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace simulation
{

/// Rain or snow in the air, as it is seen: what one drop or flake is like, how many there are, and how they
/// dim what is behind.
struct Hydrometeors
{
    bool isSnow = false;
    double perM3 = 0.0;          ///< drops of more than 2 mm, or flakes
    double sizeM = 0.0;          ///< mean diameter of these
    double fallMps = 0.0;        ///< speed of these in still air
    double extinctionPerM = 0.0; ///< of light, by drops or flakes of all sizes
};

/// Rain by the size distribution N(D) = 8000 exp(-4.1 R^-0.21 D) per m³ and mm of diameter: each drop takes
/// twice its cross-section out of the light. `mmPerHour`: 0 or more; 0: nothing.
/// Source: Marshall and Palmer, *The distribution of raindrops with size* (1948); speed: Atlas, Srivastava
/// and Sekhon, *Doppler radar characteristics of precipitation at vertical incidence* (1973), 9.65 - 10.3
/// exp(-0.6 D) m/s.
Hydrometeors rainOf(double mmPerHour);

/// Snow in flakes of 5 mm with a twentieth of the density of water, which fall by 1 m a second. `mmPerHour`:
/// as water, 0 or more. One hour's millimetre leaves 1.2 km of visibility, 2.5 half a kilometre, which part
/// light, moderate and heavy snow.
/// Source: Rasmussen, Vivekanandan, Cole, Myers and Masters, *The estimation of snowfall rate using
/// visibility* (1999), section 1.
Hydrometeors snowOf(double mmPerHour);

/// The visibility (5 % of contrast is left) of air in which something falls, of which `clearM` is the
/// visibility without. Units: metres.
double visibilityM(double clearM, const Hydrometeors& falling);

} // namespace simulation
