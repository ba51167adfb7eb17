// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <foundation/KeptFrom.h>
#include <foundation/PlainBytes.h>

#include <osg/Image>

namespace osgTerrainROAM
{

/// Returns a plain image, of one level and without gaps between its rows, as bytes for imageIn().
std::string bytesOf(const osg::Image& image);

/// Absent: bytesOf() did not write them.
std::optional<osg::ref_ptr<osg::Image>> imageIn(std::string_view bytes);

/// Returns images that are made together, found among the kept results, or made and kept
/// (KeptFrom::findOrMake()). `make`: returns them as an array.
template<std::size_t kCount, class Make>
std::array<osg::ref_ptr<osg::Image>, kCount> keptImages(const foundation::KeptFrom& kept, const char* name,
                                                        const foundation::ContentMark& more, const Make& make)
{
    using Images = std::array<osg::ref_ptr<osg::Image>, kCount>;
    const auto imagesIn = [](std::string_view bytes) -> std::optional<Images>
    {
        foundation::ValueTaker taker(bytes);
        Images images;
        std::string_view text;
        for (auto& image : images)
        {
            if (!taker.take(text)) return std::nullopt;
            const auto found = imageIn(text);
            if (!found) return std::nullopt;
            image = *found;
        }
        return taker.isEmpty() ? std::optional(images) : std::nullopt;
    };
    const auto write = [](const Images& images)
    {
        std::string bytes;
        for (const auto& image : images)
            foundation::appendText(bytes, bytesOf(*image));
        return bytes;
    };
    return kept.findOrMake(
        name, more, imagesIn, [&] { return Images{make()}; }, write);
}

/// The same of one image.
template<class Make>
osg::ref_ptr<osg::Image> keptImage(const foundation::KeptFrom& kept, const char* name,
                                   const foundation::ContentMark& more, const Make& make)
{
    return keptImages<1>(kept, name, more,
                         [&] { return std::array<osg::ref_ptr<osg::Image>, 1>{make()}; })[0];
}

} // namespace osgTerrainROAM
