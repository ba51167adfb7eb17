// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace osgSky
{

/// One of the maps of a ShadowPlan: a square across the sun's rays.
struct ShadowMap
{
    glm::dvec3 centre{0.0}; ///< light axes; along the rays the middle of the map's depths
    double reachM = 0.0;    ///< half the side

    bool operator==(const ShadowMap&) const = default;
};

/// Where the shadow maps of a frame lie: squares round the eye, each wider and coarser than the one before.
/// They neither turn with the eye nor slide with it: a map moves by whole texels, so the edge of a shadow
/// stays where it is.
/// With a cell wider than a texel a map stays where it is until the eye has passed from one cell to the next:
/// what does not move need not be drawn again until then.
/// Light axes: x and y across the rays, z towards the sun; the origin is the world's.
struct ShadowPlan
{
    static constexpr int kMaps = 4;
    /// What stands within this of the eye along the rays, either way, casts and receives.
    static constexpr double kDepthM = 20000.0;

    glm::dmat3 lightFromWorld{1.0};
    std::array<ShadowMap, kMaps> maps;

    /// `eye`: world, metres. `sun`: towards it, unit vector. `texels`: a map's side. `cellShare`: side of a
    /// cell as a share of a map's side, below 0.2; 0: a texel.
    static ShadowPlan of(const glm::dvec3& eye, const glm::dvec3& sun,
                         const std::array<double, kMaps>& reachesM, int texels, double cellShare = 0.0);

    /// The maps with their centres relative to an eye.
    std::array<ShadowMap, kMaps> from(const glm::dvec3& eye) const;
};

} // namespace osgSky
