// SPDX-License-Identifier: Apache-2.0
#include "TileableNoise.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "ParallelRows.h"

namespace osgTerrainROAM
{

namespace
{

std::uint32_t hashed(std::uint32_t x, std::uint32_t y, std::uint32_t seed)
{
    std::uint32_t h = x * 0x9e3779b1u ^ y * 0x85ebca77u ^ seed * 0xc2b2ae3du;
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    h ^= h >> 12;
    h *= 0x297a2d39u;
    return h ^ (h >> 15);
}

/// The dot product of a lattice point's gradient, one of 16 directions, with the vector from the point.
double gradientDot(std::uint32_t hash, double x, double y)
{
    static constexpr double kCos[16] = {1.0,  0.92388,  0.70711,  0.38268,  0.0, -0.38268, -0.70711, -0.92388,
                                        -1.0, -0.92388, -0.70711, -0.38268, 0.0, 0.38268,  0.70711,  0.92388};
    return kCos[hash & 15u] * x + kCos[(hash + 12u) & 15u] * y;
}

double faded(double t)
{
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

} // namespace

TileableNoise::TileableNoise(int side, const Octaves& octaves)
    : _side(side), _values(static_cast<std::size_t>(side) * side, 0.0f)
{
    assert((side & (side - 1)) == 0);
    double amplitude = 1.0;
    int frequency = octaves.firstFrequency;
    for (int i = 0; i < octaves.count; ++i)
    {
        addOctave(frequency, amplitude, octaves.seed + static_cast<std::uint32_t>(i));
        amplitude *= octaves.persistence;
        frequency *= 2;
    }
    normalize();
}

void TileableNoise::addOctave(int frequency, double amplitude, std::uint32_t seed)
{
    const auto corner = [=](int x, int y)
    {
        return hashed(static_cast<std::uint32_t>(x % frequency), static_cast<std::uint32_t>(y % frequency),
                      seed);
    };
    const auto rows = [&](int first, int end)
    {
        for (int y = first; y < end; ++y)
            for (int x = 0; x < _side; ++x)
            {
                const double u = (x + 0.5) * frequency / _side;
                const double v = (y + 0.5) * frequency / _side;
                const int i = static_cast<int>(u);
                const int j = static_cast<int>(v);
                const double fx = u - i;
                const double fy = v - j;
                const double low = std::lerp(gradientDot(corner(i, j), fx, fy),
                                             gradientDot(corner(i + 1, j), fx - 1.0, fy), faded(fx));
                const double high =
                    std::lerp(gradientDot(corner(i, j + 1), fx, fy - 1.0),
                              gradientDot(corner(i + 1, j + 1), fx - 1.0, fy - 1.0), faded(fx));
                _values[static_cast<std::size_t>(y) * _side + x] +=
                    static_cast<float>(amplitude * std::lerp(low, high, faded(fy)));
            }
    };
    parallelRows(_side, rows);
}

void TileableNoise::normalize()
{
    double sum = 0.0;
    double squares = 0.0;
    for (const float value : _values)
    {
        sum += value;
        squares += static_cast<double>(value) * value;
    }
    const double mean = sum / static_cast<double>(_values.size());
    const double deviation =
        std::sqrt(std::max(squares / static_cast<double>(_values.size()) - mean * mean, 1e-12));
    for (float& value : _values)
        value = static_cast<float>(std::clamp(0.5 + (value - mean) / (6.0 * deviation), 0.0, 1.0));
}

float TileableNoise::sample(double u, double v) const
{
    const double x = u * _side - 0.5;
    const double y = v * _side - 0.5;
    const auto i = static_cast<long long>(std::floor(x));
    const auto j = static_cast<long long>(std::floor(y));
    const auto fx = static_cast<float>(x - static_cast<double>(i));
    const auto fy = static_cast<float>(y - static_cast<double>(j));
    const int a = static_cast<int>(i & (_side - 1));
    const int b = static_cast<int>(j & (_side - 1));
    return std::lerp(std::lerp(at(a, b), at(a + 1, b), fx), std::lerp(at(a, b + 1), at(a + 1, b + 1), fx),
                     fy);
}

} // namespace osgTerrainROAM
