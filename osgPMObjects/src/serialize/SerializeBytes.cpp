// SPDX-License-Identifier: Apache-2.0
#include "SerializeBytes.h"

#include <algorithm>
#include <charconv>

#include <osgDB/InputStream>
#include <osgDB/OutputStream>

namespace osgPMObjects
{

namespace
{

constexpr std::size_t kPiece = 32768;    ///< bytes in one piece of a binary file
constexpr std::size_t kTextPiece = 4096; ///< bytes in one piece of a text

std::string digitsOf(const std::string& bytes, std::size_t from, std::size_t count)
{
    constexpr const char* kDigits = "0123456789abcdef";
    std::string digits;
    digits.reserve(2 * count);
    for (std::size_t i = from; i < from + count; ++i)
    {
        const auto byte = static_cast<unsigned char>(bytes[i]);
        digits += kDigits[byte >> 4U];
        digits += kDigits[byte & 15U];
    }
    return digits;
}

/// Returns false if these are not the hexadecimal digits of `count` bytes.
bool appendDigits(const std::string& digits, std::size_t count, std::string& bytes)
{
    if (digits.size() != 2 * count) return false;
    for (std::size_t i = 0; i < digits.size(); i += 2)
    {
        unsigned int byte = 0;
        const char* const end = digits.data() + i + 2;
        const auto read = std::from_chars(digits.data() + i, end, byte, 16);
        if (read.ec != std::errc() || read.ptr != end) return false;
        bytes += static_cast<char>(byte);
    }
    return true;
}

bool readPiece(osgDB::InputStream& in, std::size_t count, std::string& bytes)
{
    if (in.isBinary())
    {
        const std::size_t at = bytes.size();
        bytes.resize(at + count);
        in.readCharArray(bytes.data() + at,
                         static_cast<unsigned int>(count)); // reading the next size finds a failure
        return true;
    }
    std::string digits;
    in >> digits; // not a wrapped string: OSG reads one that is cut off for ever
    return in.getException() == nullptr && appendDigits(digits, count, bytes);
}

} // namespace

void writeBytes(osgDB::OutputStream& out, const std::string& bytes)
{
    const std::size_t most = out.isBinary() ? kPiece : kTextPiece;
    out << out.BEGIN_BRACKET << std::endl;
    for (std::size_t from = 0; from < bytes.size(); from += most)
    {
        const std::size_t count = std::min(most, bytes.size() - from);
        out.writeSize(count);
        if (out.isBinary())
            out.writeCharArray(bytes.data() + from, static_cast<unsigned int>(count));
        else
            out << digitsOf(bytes, from, count);
        out << std::endl;
    }
    out.writeSize(0);
    out << out.END_BRACKET << std::endl;
}

std::string readBytes(osgDB::InputStream& in)
{
    const std::size_t most = in.isBinary() ? kPiece : kTextPiece;
    in >> in.BEGIN_BRACKET;
    std::string bytes;
    while (const std::size_t count = in.readSize())
        if (in.getException() || count > most || !readPiece(in, count, bytes))
        {
            in.throwException("progressive shape: its bytes are cut off or are no hexadecimal digits");
            return {};
        }
    in >> in.END_BRACKET;
    return bytes;
}

} // namespace osgPMObjects
