// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <foundation/Random.h>

namespace islandgen
{

/// A well mixed 64-bit hash: the first number that SplitMix64 gives for a seed.
constexpr std::uint64_t mixedBits(std::uint64_t value)
{
    return foundation::SplitMix64(value)();
}

/// A hash as a number in [0, 1).
constexpr float unitFloat(std::uint64_t bits)
{
    return static_cast<float>(bits >> 40) * (1.0f / 16777216.0f);
}

/// A band-limited random function of the plane, without state: values depend on seed and position alone.
/// It uses + − · / only: every machine with IEEE arithmetic gets the same bits.
/// Frame: any; one unit is the wavelength of the first octave.
class Noise
{
public:
    explicit constexpr Noise(std::uint64_t seed) : _seed(mixedBits(seed)) {}

    /// Makes another, independent function.
    constexpr Noise channel(std::uint64_t number) const { return Noise(_seed ^ mixedBits(number + 17)); }

    /// White noise: a number in [0, 1) for each whole number.
    constexpr float at(int number) const
    {
        return unitFloat(mixedBits(_seed ^ static_cast<std::uint64_t>(number)));
    }

    /// Gradient noise, about −1…1, mean 0. Source: Perlin 2002 (quintic weights); ours: hashed gradients.
    float gradient(float x, float y) const;

    /// Sum of octaves, each turned against the one before so that no lattice shows. About −1…1 (gain 0.5).
    float fractal(float x, float y, int octaves, float gain = 0.5f) const;

    /// As fractal, with sharp crests at 1 and wide floors towards 0. Source: Musgrave's ridged multifractal.
    float ridged(float x, float y, int octaves, float gain = 0.5f) const;

private:
    std::uint64_t _seed;
};

} // namespace islandgen
