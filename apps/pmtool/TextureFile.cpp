// SPDX-License-Identifier: Apache-2.0
#include "pmtool/TextureFile.h"

#include <algorithm>
#include <cmath>

#include <osg/Image>

#include <osgOffscreen/PngFile>

namespace pmtool
{

foundation::Result<Texels> readTexels(const std::filesystem::path& file)
{
    const auto image = osgOffscreen::readPng(file);
    if (!image) return image.error();
    const osg::Image& read = **image;
    if (read.isCompressed() || !read.data() || read.s() < 1 || read.t() < 1)
        return foundation::Error{file.string(), "has texels that cannot be read", "convert it to PNG"};
    Texels texels{static_cast<std::uint32_t>(read.s()), static_cast<std::uint32_t>(read.t()), {}};
    for (std::uint32_t t = 0; t < texels.height; ++t)
        for (std::uint32_t s = 0; s < texels.width; ++s)
        {
            const osg::Vec4 c = read.getColor(s, t);
            texels.colours.emplace_back(c.r(), c.g(), c.b(), c.a());
        }
    return texels;
}

foundation::Outcome writeTexels(const Texels& texels, const std::filesystem::path& file)
{
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(static_cast<int>(texels.width), static_cast<int>(texels.height), 1, GL_RGBA,
                         GL_UNSIGNED_BYTE);
    for (std::size_t i = 0; i < texels.colours.size(); ++i)
        for (int c = 0; c < 4; ++c)
            image->data()[4 * i + static_cast<std::size_t>(c)] = static_cast<unsigned char>(
                std::lround(255.0f * std::clamp(texels.colours[i][c], 0.0f, 1.0f)));
    return osgOffscreen::writePng(*image, file);
}

} // namespace pmtool
