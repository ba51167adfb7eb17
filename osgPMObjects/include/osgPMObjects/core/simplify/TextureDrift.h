// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <osgPMObjects/core/mesh/MeasuredSurface.h>

namespace osgPMObjects::core
{

/// How far a texture has moved over a surface, in texels of a texture with 1024 a side.
struct TextureDrift
{
    static constexpr double kTexelsPerUnit = 1024.0;
    static constexpr double kVisibleTexels = 2.0;

    double mean = 0.0;
    double ofNinetyNine = 0.0; ///< 99 of 100 points drift less
    double largest = 0.0;
    double visibleShare = 0.0; ///< of the points, those that drift more than kVisibleTexels
    std::size_t samples = 0;
};

/// Measures, at the points spread over a level, how far its texture coordinates (set 0) are from those of the original at the
/// same place: on the nearest face of the same material that faces the same way. Where several are as near as the nearest, but
/// for a thousandth of the distance and a millionth of the diagonal, the least difference counts: surfaces on top of each other and
/// seams are no drift. Where none faces the same way, all count.
/// The largest value and the mean are decided by a few points beside seams, which lie nearer to the other side of a seam since the
/// surface has moved; hence the 99 %.
/// The original must stay as it is. Threads: questions from any number at once; a question is parallel.
/// Source: the deviation of textures of Cohen, Olano and Manocha, "Appearance-preserving simplification" (1998), §5, sampled instead of
/// bounded, and by nearest place, for other tools tell no correspondence.
class TextureDriftMeter
{
public:
    explicit TextureDriftMeter(const MeasuredSurface& original);
    ~TextureDriftMeter();
    TextureDriftMeter(const TextureDriftMeter&) = delete;
    TextureDriftMeter& operator=(const TextureDriftMeter&) = delete;

    /// Nothing where no face of the level has a material with texture coordinates. Materials have the numbers of the original's.
    std::optional<TextureDrift> measure(const MeasuredSurface& level) const;

private:
    class Surface; ///< faces of one material

    std::vector<std::unique_ptr<Surface>>
        _surfaces; ///< by material; none where it has no texture coordinates, or no face
};

} // namespace osgPMObjects::core
