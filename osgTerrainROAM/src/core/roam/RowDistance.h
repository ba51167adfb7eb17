// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>

#include <glm/glm.hpp>

namespace osgTerrainROAM::core
{

/// The position of a missing sample: its distance from a plane is not larger than any other.
inline constexpr glm::dvec3 kNoSample{std::numeric_limits<double>::quiet_NaN()};

/// Returns the largest squared distance of `count` consecutive samples from a plane, or `largest` if that is
/// larger. The plane's point for sample k is start + (first + k)·perSample: no division, and no error that
/// grows along the row.
inline double largestSquared(double largest, const glm::dvec3* samples, int count, const glm::dvec3& start,
                             const glm::dvec3& perSample, int first)
{
    for (int k = 0; k < count; ++k)
    {
        const glm::dvec3 drawn = start + perSample * static_cast<double>(first + k),
                         error = samples[k] - drawn;
        largest = std::max(largest, glm::dot(error, error));
    }
    return largest;
}

} // namespace osgTerrainROAM::core
