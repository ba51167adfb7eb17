// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include <osgPMObjects/core/mesh/MeasuredSurface.h>
#include <osgPMObjects/core/simplify/TextureDrift.h>

namespace osgPMObjects::core
{

/// How far a coarser level is from its original. Units: per cent of the diagonal of the original's box. Infinite where only one of the
/// two has a surface.
struct SimplificationError
{
    double meanPercent = 0.0; ///< over points spread by area on both surfaces, of the distance to the other
    double maxPercent = 0.0;  ///< over these, and all corners and centres of faces
    double boxExcessPercent = 0.0; ///< how far the level's farthest vertex lies outside of the original's box
    std::optional<TextureDrift> drift; ///< nothing where the level has no texture coordinates
};

/// Compares any number of levels with one original: whatever made them, only the meshes are looked at.
/// The original must stay as it is. Threads: questions from any number at once; a question is parallel.
/// Cost: some 0.1 s a level of 20 000 triangles. Source: see surfaceChange() and TextureDriftMeter.
class SimplificationMeter
{
public:
    static constexpr std::size_t kSpread = 60000; ///< points a side

    explicit SimplificationMeter(const Mesh& original, std::size_t spread = kSpread);

    SimplificationError measure(const Mesh& level) const;

private:
    double boxExcess(const Mesh& level) const;

    std::size_t _spread;
    Extent _box; ///< of what the original's faces use
    MeasuredSurface _original;
    TextureDriftMeter _drift;
};

/// How many materials have faces in the original and none in the level.
std::size_t countMissingMaterials(const Mesh& original, const Mesh& level);

} // namespace osgPMObjects::core
