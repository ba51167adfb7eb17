// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>

#include <glm/glm.hpp>

namespace simulation
{

/// What turbulence depends on.
struct TurbulenceConditions
{
    double speedMps = 0.0; ///< through the air
    double heightM = 0.0;  ///< above the ground
    double windAtSixMetresMps = 0.0;
    double gustDeviationMps = 0.0; ///< above 600 m
    double wingSpanM = 10.0;
};

/// Gusts along and about the axes of an aircraft that flies through random air: Dryden's spectra as filters
/// of white noise, discrete exactly for any step. The same seed gives the same gusts.
/// Source: MIL-F-8785C, *Flying Qualities of Piloted Airplanes*, 1980, section 3.7; MIL-HDBK-1797, 1997,
/// appendix A (angular rates). Below 1000 ft the scale goes with the height, above 2000 ft it is 1750 ft;
/// between, linear.
class DrydenTurbulence
{
public:
    explicit DrydenTurbulence(std::uint64_t seed) : _random(seed) {}

    void step(const TurbulenceConditions& conditions, double stepS);

    /// The air's velocity; forward, right, down; m/s.
    const glm::dvec3& velocity() const { return _velocity; }

    /// The air's turning; about forward, right, down; rad/s.
    const glm::dvec3& rates() const { return _rates; }

    /// Scale lengths and standard deviations along forward, right and down.
    struct Strength
    {
        glm::dvec3 lengthM{533.4};
        glm::dvec3 deviationMps{0.0};
    };

    static Strength strengthOf(const TurbulenceConditions& conditions);

private:
    double noise();

    /// A filter of second order whose answer to white noise has deviation 1; two states.
    struct Transverse
    {
        double first = 0.0, second = 0.0;
        double step(double decay, double stepShare, double noise);
    };

    std::mt19937_64 _random;
    double _along = 0.0, _roll = 0.0, _pitchLag = 0.0, _yawLag = 0.0;
    Transverse _across, _down;
    glm::dvec3 _velocity{0.0}, _rates{0.0};
};

} // namespace simulation
