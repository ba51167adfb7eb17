// SPDX-License-Identifier: Apache-2.0
#include <osgOffscreen/ProcessorDrawing>

namespace osgOffscreen
{

bool drawsOnProcessor(std::string_view renderer)
{
    return renderer.find("llvmpipe") != std::string_view::npos ||
           renderer.find("softpipe") != std::string_view::npos;
}

int pixelsInPlaceOf(int samples, std::string_view renderer)
{
    return samples == 4 && drawsOnProcessor(renderer) ? 2 : 1;
}

void leaveOutAnisotropy(osg::GLExtensions& gl, std::string_view renderer)
{
    if (drawsOnProcessor(renderer)) gl.isTextureFilterAnisotropicSupported = false;
}

} // namespace osgOffscreen
