// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <osgPMObjects/core/mesh/MeasuredSurface.h>

namespace osgPMObjects::core
{

/// Displacement of a texture over a surface, in texels of a texture of 1024 × 1024.
struct TextureDrift
{
    static constexpr double kTexelsPerUnit = 1024.0;
    static constexpr double kVisibleTexels = 2.0;

    double mean = 0.0;
    double ofNinetyNine = 0.0; ///< the 99th percentile
    double largest = 0.0;
    double visibleShare = 0.0; ///< share of points that drift more than kVisibleTexels
    std::size_t samples = 0;
};

/// Measures the drift of texture coordinates (set 0) between a level and its original, at points spread over
/// the level. Each point is compared with the nearest original face of the same material and orientation. Of
/// faces that are equally near, within 0.1 % of the distance and a millionth of the diagonal, the one with
/// the least difference counts, so that coincident surfaces and seams are no drift. Where no face has the
/// same orientation, all faces count.
/// A few points beside seams decide the mean and the largest value: they are nearer to the other side of a
/// seam since the surface has moved. Hence the 99th percentile. The original must not change. Threads:
/// measure() from any number at once; each call is parallel.
/// Source: the texture deviation of Cohen, Olano and Manocha, *Appearance-preserving simplification* (1998),
/// section 5. Differs: sampled, not bounded, and by nearest point, since other simplifiers give no
/// correspondence.
class TextureDriftMeter
{
public:
    explicit TextureDriftMeter(const MeasuredSurface& original);
    ~TextureDriftMeter();
    TextureDriftMeter(const TextureDriftMeter&) = delete;
    TextureDriftMeter& operator=(const TextureDriftMeter&) = delete;

    /// Empty when no face of the level has a material with texture coordinates. Materials are numbered as in
    /// the original.
    std::optional<TextureDrift> measure(const MeasuredSurface& level) const;

private:
    class Surface; ///< faces of one material

    std::vector<std::unique_ptr<Surface>>
        _surfaces; ///< by material; null without texture coordinates or faces
};

} // namespace osgPMObjects::core
