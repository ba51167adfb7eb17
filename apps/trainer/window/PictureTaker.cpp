// SPDX-License-Identifier: Apache-2.0
#include "window/PictureTaker.h"

#include <utility>

#include <osg/Image>
#include <osg/State>
#include <osgDB/WriteFile>

namespace trainer
{

std::optional<std::string> PictureTaker::takeNote()
{
    const std::scoped_lock lock(_mutex);
    return std::exchange(_note, std::nullopt);
}

void PictureTaker::operator()(osg::RenderInfo& renderInfo) const
{
    const std::scoped_lock lock(_mutex);
    const osg::Viewport* const viewport = renderInfo.getState()->getCurrentViewport();
    if (!viewport || !std::exchange(_isAsked, false)) return;
    std::filesystem::path file;
    do
        file = _folder / ("picture-" + std::to_string(++_count) + ".png");
    while (std::filesystem::exists(file) && _count < 10'000);
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    const osg::GLExtensions& gl = *renderInfo.getState()->get<osg::GLExtensions>();
    if (_buffer) _buffer->buffer().bindForReading(gl);
    image->readPixels(0, 0, static_cast<int>(viewport->width()), static_cast<int>(viewport->height()), GL_RGB,
                      GL_UNSIGNED_BYTE);
    if (_buffer) _buffer->buffer().bindForDrawing(gl);
    std::error_code ignored;
    std::filesystem::create_directories(_folder, ignored);
    _note = osgDB::writeImageFile(*image, file.string()) ? "picture: " + file.string()
                                                         : file.string() + " cannot be written";
}

} // namespace trainer
