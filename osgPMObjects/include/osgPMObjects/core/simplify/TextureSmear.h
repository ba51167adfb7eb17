// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <osgPMObjects/core/mesh/MeasuredSurface.h>

namespace osgPMObjects::core
{

/// How far a level shows its texture from where the original has it: distances in space, in units of the
/// positions.
struct TextureSmear
{
    double mean = 0.0;         ///< over the points whose coordinates the original has somewhere
    double ofNinetyNine = 0.0; ///< the 99th percentile of those
    double farShare =
        0.0; ///< share of points whose texture is farther away than allowed, or nowhere on the original
    std::size_t samples = 0;
};

/// Measures for points spread over a level how far away the original has the same texture coordinates (set 0)
/// on a face of the same material. Coordinates that the original has nowhere, within two texels of a texture
/// of 1024 × 1024, lie between its charts: there the level smears one chart into another. TextureDrift
/// compares the other way round, by nearest place, which beside the border of two charts says how far apart
/// they are in the image. Where a texture repeats, the nearest repetition counts. The original must not
/// change. Threads: measure() from any number at once; each call is parallel.
/// Source: the texture deviation of Cohen, Olano and Manocha, *Appearance-preserving simplification* (1998),
/// section 5. Differs: sampled.
class TextureSmearMeter
{
public:
    explicit TextureSmearMeter(const MeasuredSurface& original);
    ~TextureSmearMeter();
    TextureSmearMeter(const TextureSmearMeter&) = delete;
    TextureSmearMeter& operator=(const TextureSmearMeter&) = delete;

    /// `allowed`: distance up to which a texture may be shifted, such as the level's largest distance from
    /// the original: then it is shifted by more than a pixel where the level is shown with an error of one.
    /// Empty where nothing has texture coordinates.
    std::optional<TextureSmear> measure(const MeasuredSurface& level, double allowed) const;

private:
    class Chart; ///< faces of one material in the plane of the texture

    std::vector<std::unique_ptr<Chart>> _charts; ///< by material; null without texture coordinates or faces
};

} // namespace osgPMObjects::core
