// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

namespace measurement
{

/// A direction as an observer at sea level sees it without air. Degrees, azimuth clockwise from north.
struct SeenAt
{
    double azimuthDeg, elevationDeg;
};

/// Sun and moon as one oracle sees them; what share of the moon's disc is lit.
struct KnownLights
{
    SeenAt sun, moon;
    double litShare;
};

/// An instant and a place, and what two oracles see there: PyEphem 4.1.4 (libastro) and ERFA 2.0.0 (epv00,
/// moon98, pnm06a, gst06a; with dynamical time by Espenak and Meeus). They are 0.0003 degrees apart for the
/// sun, 0.003 for the moon and 0.4 % in the phase. Times are universal time.
struct KnownInstant
{
    const char* time;
    double latitudeDeg, longitudeDeg;
    KnownLights pyEphem, erfa;
};

/// Returns twenty of them, 1950 to 2049, from 55 degrees south to 64 north.
std::span<const KnownInstant> knownInstants();

/// Stars whose places are known, with PyEphem's motion of their own: Sirius, Canopus, Arcturus, Vega, Rigel,
/// Procyon, Altair, Aldebaran, Polaris, Fomalhaut.
struct KnownStars
{
    const char* time;
    double latitudeDeg, longitudeDeg;
    std::array<SeenAt, 10> stars;
};

/// Returns them for 1950, 1999 and 2049.
std::span<const KnownStars> knownStars();

/// When the upper edge of the sun appears or vanishes by the almanac: 34' of refraction at the horizon.
struct KnownSunrise
{
    const char* time;
    double latitudeDeg, longitudeDeg;
    bool isRise;
};

/// Returns twelve of them by PyEphem, 1960 to 2045.
std::span<const KnownSunrise> knownSunrises();

} // namespace measurement
