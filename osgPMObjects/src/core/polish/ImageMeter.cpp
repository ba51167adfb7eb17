// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <osgPMObjects/core/Parallel.h>
#include <osgPMObjects/core/polish/ImageMeter.h>

#include "FragmentPicture.h"
#include "PolishState.h"

namespace osgPMObjects::core
{

namespace
{

constexpr float kNothing = -1.0f;

/// The pixels of one view, or of several together.
struct PixelCounts
{
    std::size_t original = 0, level = 0, both = 0, either = 0;
    double squares = 0.0; ///< of luminance differences

    double areaRatio() const
    {
        return original > 0 ? static_cast<double>(level) / static_cast<double>(original) : 1.0;
    }

    void add(const PixelCounts& more)
    {
        original += more.original;
        level += more.level;
        both += more.both;
        either += more.either;
        squares += more.squares;
    }
};

PixelCounts compare(std::span<const float> original, std::span<const float> level, float background)
{
    PixelCounts counts;
    for (std::size_t i = 0; i < original.size(); ++i)
    {
        const bool inOriginal = original[i] != kNothing, inLevel = level[i] != kNothing;
        counts.original += inOriginal;
        counts.level += inLevel;
        counts.both += inOriginal && inLevel;
        counts.either += inOriginal || inLevel;
        const double gap = (inOriginal ? original[i] : background) - (inLevel ? level[i] : background);
        counts.squares += gap * gap;
    }
    return counts;
}

} // namespace

ImageMeter::ImageMeter(const Mesh& original, std::span<const MaterialLook> looks,
                       const ImageMeterSettings& settings)
    : _settings(settings), _looks(looks.begin(), looks.end()), _positions(original.positions)
{
    _original = imagesOf(original, 0, settings.views);
}

std::vector<ImageMeter::Luminances> ImageMeter::imagesOf(const Mesh& mesh, int first, int last) const
{
    std::vector<SeenMaterial> materials = seenMaterials(mesh, _looks);
    for (SeenMaterial& material : materials)
    {
        material.isTwoSided = true;
        material.isTransparent = false;
    }
    const std::vector<SeenFace> faces = seenFaces(mesh, ImageFrame(_positions), materials);
    const std::vector<PictureView> views = viewsAround(_settings.views);
    std::vector<Luminances> images(static_cast<std::size_t>(last - first));
    parallelShares(images.size(), 1,
                   [&](std::size_t from, std::size_t to, std::size_t)
                   {
                       for (std::size_t i = from; i < to; ++i)
                       {
                           FragmentPicture picture(views[static_cast<std::size_t>(first) + i],
                                                   _settings.sizePx, kNothing);
                           for (const SeenFace& face : faces)
                               picture.add(face);
                           images[i] = picture.luminances();
                       }
                   });
    return images;
}

ImageDifference ImageMeter::measure(const Mesh& level) const
{
    const std::vector<Luminances> images = imagesOf(level, 0, _settings.views);
    PixelCounts all;
    ImageDifference difference;
    for (std::size_t view = 0; view < images.size(); ++view)
    {
        const PixelCounts counts = compare(_original[view], images[view], _settings.background);
        const double ratio = counts.areaRatio();
        difference.leastAreaRatio = view == 0 ? ratio : std::min(ratio, difference.leastAreaRatio);
        difference.mostAreaRatio = view == 0 ? ratio : std::max(ratio, difference.mostAreaRatio);
        all.add(counts);
    }
    difference.areaRatio = all.areaRatio();
    if (all.original > 0)
        difference.covered = static_cast<double>(all.both) / static_cast<double>(all.original);
    if (all.either > 0) difference.luminance = std::sqrt(all.squares / static_cast<double>(all.either));
    return difference;
}

std::vector<std::uint8_t> ImageMeter::image(const Mesh& mesh, int view) const
{
    const Luminances luminances = imagesOf(mesh, view, view + 1).front();
    std::vector<std::uint8_t> bytes;
    bytes.reserve(luminances.size());
    for (const float luminance : luminances)
    {
        const float shown = luminance == kNothing ? _settings.background : luminance;
        bytes.push_back(static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(shown, 0.0f, 1.0f))));
    }
    return bytes;
}

} // namespace osgPMObjects::core
