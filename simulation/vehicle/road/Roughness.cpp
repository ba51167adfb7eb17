// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/road/Roughness.h"

#include <cmath>
#include <cstdint>

#include <foundation/Random.h>
#include <glm/common.hpp>

namespace simulation
{

namespace
{

/// A number of -1…1 for a point of the lattice.
double latticeValue(std::int64_t x, std::int64_t y)
{
    std::uint64_t bits = static_cast<std::uint64_t>(x) * foundation::SplitMix64::kStep +
                         static_cast<std::uint64_t>(y) * 0xC2B2AE3D27D4EB4FU;
    bits ^= bits >> 31U;
    bits *= 0x7FB5D329728EA185U;
    bits ^= bits >> 27U;
    bits *= 0x81DADEF4BC2DD44DU;
    bits ^= bits >> 33U;
    return static_cast<double>(bits >> 11U) / 4503599627370496.0 - 1.0;
}

double smoothNoise(double x, double y)
{
    const double left = std::floor(x), low = std::floor(y);
    const auto column = static_cast<std::int64_t>(left), row = static_cast<std::int64_t>(low);
    const double u = glm::smoothstep(0.0, 1.0, x - left), v = glm::smoothstep(0.0, 1.0, y - low);
    const double first = latticeValue(column, row) * (1.0 - u) + latticeValue(column + 1, row) * u;
    const double second = latticeValue(column, row + 1) * (1.0 - u) + latticeValue(column + 1, row + 1) * u;
    return first * (1.0 - v) + second * v;
}

} // namespace

double roughnessAmplitudeM(GroundKind kind)
{
    switch (kind)
    {
    case GroundKind::asphalt:
    case GroundKind::wetAsphalt:
        return 0.0008;
    case GroundKind::gravel:
        return 0.006;
    case GroundKind::grass:
        return 0.008;
    case GroundKind::snow:
        return 0.004;
    case GroundKind::ice:
        return 0.001;
    case GroundKind::water:
        return 0.0;
    }
    return 0.0;
}

double roughnessM(GroundKind kind, const glm::dvec3& place)
{
    constexpr double kMostM = 1e9; // farther out the lattice has no numbers
    const double amplitude = roughnessAmplitudeM(kind);
    if (amplitude == 0.0 || !(std::abs(place.x) < kMostM) || !(std::abs(place.y) < kMostM)) return 0.0;
    const double longWave = smoothNoise(place.x / 4.0, place.y / 4.0);
    const double shortWave = smoothNoise(place.x + 0.37, place.y + 0.59);
    return amplitude * (0.7 * longWave + 0.3 * shortWave);
}

} // namespace simulation
