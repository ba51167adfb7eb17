// SPDX-License-Identifier: Apache-2.0
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>

#include <osgDB/ReadFile>
#include <osgDB/Registry>

#include <osgOffscreen/PngFile>

namespace osgOffscreen
{

using viewlod::Error;
using viewlod::Outcome;
using viewlod::Result;

namespace
{

std::string reasonOf(int errorNumber)
{
    return std::generic_category().message(errorNumber);
}

/// Whole under its final name, or not there.
Outcome writeWhole(const std::string& bytes, const std::filesystem::path& path)
{
    std::filesystem::path temporary = path;
    temporary += ".part";
    errno = 0;
    std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file)
    {
        const std::string reason = reasonOf(errno);
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        return Error{path.string(), "cannot be written: " + reason, "choose a folder that can be written to"};
    }
    std::error_code failed;
    std::filesystem::rename(temporary, path, failed);
    if (!failed) return viewlod::success();
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    return Error{path.string(), "cannot be renamed into place: " + failed.message(),
                 "choose a folder that can be written to"};
}

} // namespace

Outcome writePng(const osg::Image& picture, const std::filesystem::path& path)
{
    osgDB::ReaderWriter* png = osgDB::Registry::instance()->getReaderWriterForExtension("png");
    if (!png) return Error{path.string(), "OpenSceneGraph's png plugin is missing", "install openscenegraph"};
    // Encoded in memory first: the plugin does not look at what the file's stream says.
    std::ostringstream encoded;
    const osg::ref_ptr<osgDB::Options> options =
        new osgDB::Options("PNG_COMPRESSION 3"); // half the time of 6, 1.2 times the size
    const osgDB::ReaderWriter::WriteResult result = png->writeImage(picture, encoded, options);
    if (!result.success())
        return Error{path.string(), "the picture cannot be written as PNG " + result.message(),
                     "give an RGB or RGBA picture of 8 bits"};
    return writeWhole(encoded.str(), path);
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
