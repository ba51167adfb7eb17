// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "simulation/environment/CloudLayer.h"

namespace scenery::clouds
{

/// A layer of clouds as a raster that repeats from east to west and from south to north: what a ray through
/// it needs. A sample is [slice][row][column], the lowest slice first, samples in the middle of their cells.
/// Frame: columns to the east, rows to the north. Units: metres, bytes.
struct CloudVolume
{
    static constexpr int kSide = 256, kSlices = 16;
    static constexpr double kTileM = 20480.0, kCellM = kTileM / kSide;
    static constexpr double kGapStepM = 8.0; ///< a step of `gap`
    static constexpr int kSurface = 128;     ///< of `form`: the edge of a cloud; 255 is well within

    double baseM = 0.0, topM = 0.0;   ///< as the layer has them
    double extinctionPerM = 0.0;      ///< well within a cloud
    float sharpness = 1.0F;           ///< how fast the density grows behind the edge
    std::vector<std::uint8_t> form;   ///< above kSurface: cloud
    std::vector<std::uint8_t> gap;    ///< distance to the nearest cloud at least, in kGapStepM
    std::vector<std::uint8_t> skylit; ///< what of the light of the sky arrives, 255: all

    double sliceM() const { return (topM - baseM) / kSlices; }

    /// Density, 0 … 1, of a sample.
    float density(std::size_t sample) const
    {
        const float within = sharpness * static_cast<float>(form[sample] - kSurface) / 127.0F;
        return within < 0.0F ? 0.0F : (within > 1.0F ? 1.0F : within);
    }
};

/// Makes the clouds of a layer; as many columns hold cloud as its oktas say. The same on every machine.
/// Cost: about 0.3 s.
CloudVolume makeCloudVolume(const simulation::CloudLayer& layer, std::uint32_t seed);

/// What of the sun's light arrives at each sample, 255: all, in the order of CloudVolume::form, and below the
/// layer: the last kSide x kSide of `below`.
struct SunInClouds
{
    std::vector<std::uint8_t> within;
    std::vector<float> below; ///< share 0 … 1 at the base, [row][column]
};

/// Computes it for the direction towards the sun (a sun below 6 degrees stands there). Light that is
/// scattered forwards goes on: the depth of a cloud counts by a part.
/// Cost: about 20 ms, more for a low sun.
SunInClouds sunInClouds(const CloudVolume& volume, const glm::vec3& towardsSun);

/// Shares of the sun below all layers on the plane of the lowest base, 0 … 255, [row][column], where each
/// layer has its own `sun`; white without layers.
std::vector<std::uint8_t> shadeBelow(const std::vector<CloudVolume>& volumes,
                                     const std::vector<SunInClouds>& suns, const glm::vec3& towardsSun);

/// Returns the optical depth of a layer along a ray from a place below it, steps of 10 m of height.
double opticalDepth(const CloudVolume& volume, const glm::dvec3& from, const glm::dvec3& direction);

} // namespace scenery::clouds
