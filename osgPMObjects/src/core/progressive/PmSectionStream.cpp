// SPDX-License-Identifier: Apache-2.0
#include "PmSectionStream.h"

#include <algorithm>

#include "PmSections.h"

namespace osgPMObjects::core
{

namespace
{

std::string printable(std::string letters)
{
    std::replace_if(
        letters.begin(), letters.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return letters;
}

} // namespace

foundation::Error PmSectionStream::damaged(const std::string& what) const
{
    return {_place + ": at byte " + std::to_string(_at), what, "build the file again from its model"};
}

/// Reads `count` bytes, or fewer at the end of the stream. It reads in pieces, so that a damaged length
/// cannot ask for all memory.
std::string PmSectionStream::take(std::uint64_t count)
{
    constexpr std::uint64_t kPiece = 1 << 20;
    std::string bytes;
    while (count > 0 && _stream)
    {
        const std::size_t before = bytes.size();
        bytes.resize(before + std::min(count, kPiece));
        _stream.read(bytes.data() + before, static_cast<std::streamsize>(bytes.size() - before));
        bytes.resize(before + static_cast<std::size_t>(_stream.gcount()));
        count -= bytes.size() - before;
    }
    _at += bytes.size();
    return bytes;
}

foundation::Outcome PmSectionStream::readBegin()
{
    const auto begin = _stream.tellg();
    if (begin >= 0 && _stream.seekg(0, std::ios::end))
    {
        _size = static_cast<std::uint64_t>(_stream.tellg() - begin);
        _stream.seekg(begin);
    }
    _stream.clear();
    const std::string magic = take(kPmMagic.size() + sizeof kPmVersion);
    if (!magic.starts_with(kPmMagic))
        return foundation::Error{_place, "is not a progressive mesh", "make one with pmtool build"};
    const auto version = PmByteReader(std::string_view(magic).substr(kPmMagic.size())).get<std::uint32_t>();
    if (version == 0 || version > kPmVersion)
        return foundation::Error{
            _place, "is of version " + std::to_string(version) + ", not 1 to " + std::to_string(kPmVersion),
            "build it again with this pmtool"};
    _version = version;
    return foundation::success();
}

foundation::Outcome PmSectionStream::read(Section& section)
{
    constexpr std::size_t kHead = 12, kSum = 4;
    std::string all = take(kHead);
    _isCutOff = all.size() < kHead;
    if (_isCutOff) return damaged("is cut off before a section");
    section.letters = all.substr(0, 4);
    const auto length = PmByteReader(std::string_view(all).substr(4)).get<std::uint64_t>();
    section.contents = take(length);
    const std::string sum = take(kSum);
    _isCutOff = section.contents.size() != length || sum.size() < kSum;
    if (_isCutOff) return damaged("is cut off in a section " + printable(section.letters));
    all += section.contents;
    if (PmByteReader(sum).get<std::uint32_t>() != pmCheckSum(all))
        return damaged("is damaged in a section " + printable(section.letters) +
                       ": its check sum is another");
    return foundation::success();
}

foundation::Outcome PmSectionStream::read(std::string_view letters, std::string& contents)
{
    Section section;
    if (auto done = read(section); !done) return done;
    if (section.letters != letters)
        return damaged("has a section " + printable(section.letters) + " where " + std::string(letters) +
                       " belongs");
    contents = std::move(section.contents);
    return foundation::success();
}

} // namespace osgPMObjects::core
