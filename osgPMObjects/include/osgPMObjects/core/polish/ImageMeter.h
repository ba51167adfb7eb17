// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/polish/PolishByImages.h>

namespace osgPMObjects::core
{

/// Settings of ImageMeter.
struct ImageMeterSettings
{
    int views = 16;           ///< view directions all around, from above to below
    int sizePx = 256;         ///< width and height of each image; the original fills it
    float background = 0.45f; ///< luminance of the background
};

/// The difference between the images of a level and those of its original, over all views.
struct ImageDifference
{
    double areaRatio = 1.0; ///< area of the level's silhouettes by that of the original's, sums of all views
    double leastAreaRatio = 1.0; ///< the same of the view where it is least
    double mostAreaRatio = 1.0;  ///< the same of the view where it is most
    double covered = 1.0;        ///< share of the original's pixels that the level covers
    double luminance = 0.0;      ///< root mean square of the difference over pixels that either covers, 0…1
};

/// Measures what the eye sees of a level: images of it from all around are compared with those of its
/// original, by parallel projection, lit by a lamp at the camera. Faces are drawn from both sides, and
/// transparent ones as opaque, so that a silhouette has no hole where the surface has none.
/// Frame: the level must have the frame and the material numbers of the original. Memory: 4 B a pixel and
/// view, and 16 B a pixel of each face in the view that is being drawn, for each thread. Deterministic.
/// Source: Lindstrom and Turk, *Image-driven simplification* (2000), section 3 (images from all around as the
/// error).
class ImageMeter
{
public:
    /// `looks`: by material; missing ones are white. Copies what it needs of both.
    explicit ImageMeter(const Mesh& original, std::span<const MaterialLook> looks = {},
                        const ImageMeterSettings& settings = {});

    ImageDifference measure(const Mesh& level) const;

    /// The image of a mesh in one view, `sizePx` rows from below, one byte of luminance a pixel.
    std::vector<std::uint8_t> image(const Mesh& mesh, int view) const;

    const ImageMeterSettings& settings() const { return _settings; }

private:
    /// By pixel: the luminance; -1 where nothing is covered.
    using Luminances = std::vector<float>;

    /// The images of the views from `first` to `last`, without that.
    std::vector<Luminances> imagesOf(const Mesh& mesh, int first, int last) const;

    ImageMeterSettings _settings;
    std::vector<MaterialLook> _looks;
    std::vector<glm::dvec3> _positions; ///< of the original: they give the frame of the images
    std::vector<Luminances> _original;  ///< by view
};

} // namespace osgPMObjects::core
