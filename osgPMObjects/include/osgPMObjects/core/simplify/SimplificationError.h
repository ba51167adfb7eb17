// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include <osgPMObjects/core/mesh/MeasuredSurface.h>
#include <osgPMObjects/core/simplify/TextureDrift.h>
#include <osgPMObjects/core/simplify/TextureSmear.h>

namespace osgPMObjects::core
{

/// Measured distances between a level of detail and its original, in per cent of the diagonal of the
/// original's box. Infinite when only one of the two has a surface.
struct SimplificationError
{
    double meanPercent = 0.0; ///< mean distance to the other surface, over points spread by area on both
    double maxPercent = 0.0;  ///< largest distance, over these points and all corners and centres of faces
    double boxExcessPercent = 0.0; ///< distance of the level's farthest vertex outside of the original's box
    std::optional<TextureDrift> drift; ///< empty when the level has no texture coordinates
    std::optional<TextureSmear>
        smear; ///< the same, in per cent of the diagonal; far: farther than the largest distance
};

/// Compares levels of any origin with one original. Only the meshes are read.
/// The original must not change. Threads: measure() from any number at once; each call is parallel.
/// Cost: some 0.1 s a level of 20 000 triangles. Source: see surfaceChange() and TextureDriftMeter.
class SimplificationMeter
{
public:
    static constexpr std::size_t kSpread = 60000; ///< points on each surface

    explicit SimplificationMeter(const Mesh& original, std::size_t spread = kSpread);

    SimplificationError measure(const Mesh& level) const;

private:
    double boxExcess(const Mesh& level) const;

    std::size_t _spread;
    Extent _box; ///< of the positions that the original's faces use
    MeasuredSurface _original;
    TextureDriftMeter _drift;
    TextureSmearMeter _smear;
};

/// Counts the materials that have faces in the original and none in the level.
std::size_t countMissingMaterials(const Mesh& original, const Mesh& level);

} // namespace osgPMObjects::core
