// SPDX-License-Identifier: Apache-2.0
#include "Noise.h"

namespace islandgen
{

namespace
{

int floorToInt(float x)
{
    const int truncated = static_cast<int>(x);
    return static_cast<float>(truncated) > x ? truncated - 1 : truncated;
}

float quintic(float t)
{
    return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
}

float mix(float a, float b, float t)
{
    return a + (b - a) * t;
}

/// Dot product of the lattice point's random vector with the offset from it.
float cornerValue(std::uint64_t seed, int column, int row, float dx, float dy)
{
    const auto place = (static_cast<std::uint64_t>(static_cast<std::uint32_t>(column)) << 32) |
                       static_cast<std::uint32_t>(row);
    const std::uint64_t bits = mixedBits(seed ^ mixedBits(place));
    const float gx = unitFloat(bits) * 2.0f - 1.0f;
    const float gy = unitFloat(bits << 24) * 2.0f - 1.0f;
    return gx * dx + gy * dy;
}

} // namespace

float Noise::gradient(float x, float y) const
{
    const int column = floorToInt(x);
    const int row = floorToInt(y);
    const float fx = x - static_cast<float>(column);
    const float fy = y - static_cast<float>(row);
    const float south = mix(cornerValue(_seed, column, row, fx, fy),
                            cornerValue(_seed, column + 1, row, fx - 1.0f, fy), quintic(fx));
    const float north = mix(cornerValue(_seed, column, row + 1, fx, fy - 1.0f),
                            cornerValue(_seed, column + 1, row + 1, fx - 1.0f, fy - 1.0f), quintic(fx));
    return 1.8f * mix(south, north, quintic(fy));
}

float Noise::fractal(float x, float y, int octaves, float gain) const
{
    float sum = 0.0f;
    float amplitude = 1.0f;
    for (int octave = 0; octave < octaves; ++octave)
    {
        sum += amplitude * gradient(x, y);
        amplitude *= gain;
        // Twice the frequency, turned by the 3-4-5 triangle's angle, moved off the common origin.
        const float turned = 2.0f * (0.8f * x - 0.6f * y) + 13.7f;
        y = 2.0f * (0.6f * x + 0.8f * y) - 7.3f;
        x = turned;
    }
    return sum;
}

float Noise::ridged(float x, float y, int octaves, float gain) const
{
    float sum = 0.0f;
    float total = 0.0f;
    float amplitude = 1.0f;
    for (int octave = 0; octave < octaves; ++octave)
    {
        const float value = gradient(x, y);
        const float crest = 1.0f - (value < 0.0f ? -value : value);
        sum += amplitude * crest * crest;
        total += amplitude;
        amplitude *= gain;
        const float turned = 2.0f * (0.8f * x - 0.6f * y) + 13.7f;
        y = 2.0f * (0.6f * x + 0.8f * y) - 7.3f;
        x = turned;
    }
    return sum / total;
}

} // namespace islandgen
