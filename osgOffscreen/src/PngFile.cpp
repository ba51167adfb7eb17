// SPDX-License-Identifier: Apache-2.0
#include <sstream>
#include <string>
#include <system_error>

#include <foundation/WholeFile.h>

#include <osgDB/ReadFile>
#include <osgDB/Registry>

#include <osgOffscreen/PngFile>

namespace osgOffscreen
{

using foundation::Error;
using foundation::Outcome;
using foundation::Result;

Outcome writePng(const osg::Image& picture, const std::filesystem::path& path)
{
    osgDB::ReaderWriter* png = osgDB::Registry::instance()->getReaderWriterForExtension("png");
    if (!png) return Error{path.string(), "OpenSceneGraph's png plugin is missing", "install openscenegraph"};
    // Encoded in memory first, because the plugin does not check the state of the file's stream.
    std::ostringstream encoded;
    const osg::ref_ptr<osgDB::Options> options =
        new osgDB::Options("PNG_COMPRESSION 3"); // half the time of 6, 1.2 times the size
    const osgDB::ReaderWriter::WriteResult result = png->writeImage(picture, encoded, options);
    if (!result.success())
        return Error{path.string(), "the picture cannot be written as PNG " + result.message(),
                     "give an RGB or RGBA picture of 8 bits"};
    return foundation::writeWholeFile(path, encoded.str());
}

Result<osg::ref_ptr<osg::Image>> readPng(const std::filesystem::path& path)
{
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored))
        return Error{path.string(), "no such file", "check the name"};
    const osg::ref_ptr<osg::Image> picture = osgDB::readRefImageFile(path.string());
    if (!picture) return Error{path.string(), "is not a picture that can be read", "make it anew"};
    return picture;
}

} // namespace osgOffscreen
