// SPDX-License-Identifier: Apache-2.0
#include "ImageFiles.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <system_error>

#include <osg/ValueObject>
#include <osgDB/FileNameUtils>
#include <osgDB/Registry>

namespace osgPMObjects
{

namespace
{

using core::PmImage;

/// The largest difference between two decoders of the same JPEG file; units: 1/255.
constexpr int kMostDifference = 8;

using Texel = std::array<unsigned char, 4>;

/// Returns a texel of 8-bit channels as red, green, blue and alpha.
Texel texelOf(const osg::Image& image, int s, int t, int r)
{
    const unsigned char* const at =
        image.data(static_cast<unsigned>(s), static_cast<unsigned>(t), static_cast<unsigned>(r));
    switch (image.getPixelFormat())
    {
    case GL_LUMINANCE:
        return {at[0], at[0], at[0], 255};
    case GL_LUMINANCE_ALPHA:
        return {at[0], at[0], at[0], at[1]};
    case GL_RGB:
        return {at[0], at[1], at[2], 255};
    default:
        return {at[0], at[1], at[2], at[3]};
    }
}

bool hasTexels(const osg::Image& image)
{
    const GLenum format = image.getPixelFormat();
    return image.getDataType() == GL_UNSIGNED_BYTE &&
           (format == GL_LUMINANCE || format == GL_LUMINANCE_ALPHA || format == GL_RGB || format == GL_RGBA);
}

bool haveNearTexels(const osg::Image& a, const osg::Image& b)
{
    for (int r = 0; r < a.r(); ++r)
        for (int t = 0; t < a.t(); ++t)
            for (int s = 0; s < a.s(); ++s)
            {
                const Texel x = texelOf(a, s, t, r), y = texelOf(b, s, t, r);
                for (std::size_t c = 0; c < x.size(); ++c)
                    if (std::abs(x[c] - y[c]) > kMostDifference) return false;
            }
    return true;
}

bool haveEqualBytes(const osg::Image& a, const osg::Image& b)
{
    if (a.getPixelFormat() != b.getPixelFormat() || a.getDataType() != b.getDataType() ||
        a.getRowSizeInBytes() != b.getRowSizeInBytes() || a.getNumMipmapLevels() != b.getNumMipmapLevels() ||
        a.getTotalSizeInBytesIncludingMipmaps() != b.getTotalSizeInBytesIncludingMipmaps())
        return false;
    if (a.isMipmap() || a.isCompressed())
        return a.getPacking() == b.getPacking() &&
               std::memcmp(a.data(), b.data(), a.getTotalSizeInBytesIncludingMipmaps()) == 0;
    for (unsigned r = 0; r < static_cast<unsigned>(a.r()); ++r)
        for (unsigned t = 0; t < static_cast<unsigned>(a.t()); ++t)
            if (std::memcmp(a.data(0, t, r), b.data(0, t, r), a.getRowSizeInBytes()) != 0) return false;
    return true;
}

bool showTheSame(const osg::Image& a, const osg::Image& b)
{
    if (a.s() != b.s() || a.t() != b.t() || a.r() != b.r() || a.data() == nullptr || b.data() == nullptr)
        return false;
    const bool areTexels = hasTexels(a) && hasTexels(b) && !a.isMipmap() && !b.isMipmap();
    return areTexels ? haveNearTexels(a, b) : haveEqualBytes(a, b);
}

osgDB::ReaderWriter* pluginFor(const std::string& format)
{
    return osgDB::Registry::instance()->getReaderWriterForExtension(format);
}

std::string bytesOf(const std::filesystem::path& file)
{
    std::error_code failed;
    if (!std::filesystem::is_regular_file(file, failed)) return {};
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::string extensionOf(const std::string& bytes)
{
    if (bytes.starts_with("\x89PNG")) return "png";
    return bytes.starts_with("\xff\xd8") ? "jpg" : "";
}

/// Returns the file from which an image came; without bytes where it is not known.
PmImage origin(const osg::Image& image, const std::filesystem::path& folder)
{
    PmImage file{image.getFileName(), {}, false, {}};
    if (image.getUserValue(kImageFileValue, file.bytes))
    {
        file.format = extensionOf(file.bytes);
        return file;
    }
    if (file.name.empty()) return file;
    file.format = osgDB::getLowerCaseFileExtension(file.name);
    file.bytes = bytesOf(file.name);
    if (file.bytes.empty()) file.bytes = bytesOf(folder / file.name);
    return file;
}

/// Encodes an image by a plugin of OpenSceneGraph.
PmImage encodedAs(const osg::Image& image, const char* format, const char* options)
{
    PmImage file{image.getFileName(), format, false, {}};
    const osg::ref_ptr<osgDB::ReaderWriter> plugin = pluginFor(format);
    std::ostringstream stream;
    const osg::ref_ptr<osgDB::Options> given = new osgDB::Options(options);
    if (plugin && plugin->writeImage(image, stream, given).success()) file.bytes = stream.str();
    return file;
}

} // namespace

PmImage asImageFile(const osg::Image& image, const std::filesystem::path& folder)
{
    PmImage best{image.getFileName(), {}, false, {}};
    const auto consider = [&](PmImage file)
    {
        if (file.bytes.empty() || (!best.bytes.empty() && file.bytes.size() >= best.bytes.size())) return;
        for (const bool isFlipped : {false, true})
        {
            file.isFlipped = isFlipped;
            const osg::ref_ptr<osg::Image> shown = decoded(file);
            if (!shown || !showTheSame(*shown, image)) continue;
            best = std::move(file);
            return;
        }
    };
    consider(origin(image, folder));
    if (hasTexels(image) && image.r() == 1 && !image.isMipmap() && extensionOf(best.bytes).empty())
        consider(encodedAs(image, "png", ""));
    if (best.bytes.empty()) consider(encodedAs(image, "osgb", "WriteImageHint=IncludeData Compressor=zlib"));
    return best;
}

osg::ref_ptr<osg::Image> decoded(const PmImage& file)
{
    const osg::ref_ptr<osgDB::ReaderWriter> plugin = pluginFor(file.format);
    if (!plugin) return nullptr;
    std::istringstream stream(file.bytes);
    osgDB::ReaderWriter::ReadResult read = plugin->readImage(stream, nullptr);
    const osg::ref_ptr<osg::Image> image = read.getImage();
    if (!image || image->data() == nullptr) return nullptr;
    if (file.isFlipped) image->flipVertical();
    image->setFileName(file.name);
    return image;
}

} // namespace osgPMObjects
