// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Texture2D>

namespace osgTerrainROAM
{

/// Makes a texture of an image, filtered, with mip levels, that keeps its size.
inline osg::ref_ptr<osg::Texture2D> mapTexture(osg::Image* image, osg::Texture::WrapMode wrap)
{
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setResizeNonPowerOfTwoHint(false);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, wrap);
    texture->setWrap(osg::Texture::WRAP_T, wrap);
    return texture;
}

} // namespace osgTerrainROAM
