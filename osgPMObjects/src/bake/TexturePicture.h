// -*- c++ -*-
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <osg/Texture>

namespace osgPMObjects
{

/// The image of a texture, unpacked, and how it is sampled: repeated, mirrored or clamped, with or without
/// interpolation.
/// Threads: any number at once.
class TexturePicture
{
public:
    /// Of a texture without an image in memory, or with a compressed one, nothing can be read: isRead() is
    /// false.
    explicit TexturePicture(const osg::Texture& texture);

    bool isRead() const { return !_texels.empty(); }

    /// Returns red, green, blue and alpha, 0…1; texture coordinates as in OpenGL.
    glm::vec4 at(const glm::dvec2& place) const;

private:
    enum class Wrap
    {
        repeat,
        mirror,
        clamp
    };

    static Wrap wrapOf(osg::Texture::WrapMode mode);
    static int wrapped(int texel, int count, Wrap wrap);
    glm::vec4 texel(int s, int t) const;

    int _width = 0, _height = 0;
    Wrap _wrapS, _wrapT;
    bool _isNearest;
    std::vector<std::array<std::uint8_t, 4>> _texels;
};

} // namespace osgPMObjects
