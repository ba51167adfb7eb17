// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace osgPMObjects::core
{

/// The format of a `.pm` file: kPmMagic, a version, then sections. A section has four letters, its size in
/// bytes, its contents and a check sum (CRC-32) of all that. Numbers have their lowest byte first.
/// docs/reference/pm-file.md describes the sections.
constexpr std::string_view kPmMagic{"OSGPM\x1a\r\n", 8}; // a transfer as text would change it
/// Versions 2 and 3 had the records as they are in memory, version 2 without cycles; version 1 no images, and
/// all positions of the coarsest level in BASE.
constexpr std::uint32_t kPmVersion = 4;

/// A run of positions in BASE whose vertices follow later, instead of the count of a position's wedges: this
/// bit, the wedges of each position, the number of positions.
constexpr std::uint32_t kPmLater = 0x80000000, kPmLaterWedgesShift = 16, kPmLaterMostWedges = 0x7fff,
                        kPmLaterMostPositions = 0xffff;

constexpr std::string_view kPmHead = "HEAD", kPmMaterials = "MATL", kPmAttachment = "ATCH",
                           kPmLayout = "LAYO", kPmBase = "BASE", kPmLadder = "LADR", kPmImage = "IMAG",
                           kPmSteps = "STEP", kPmEnd = "DONE";

/// The arrays that wedges have, and their form.
enum PmFlag : std::uint32_t
{
    pmNormals = 1,
    pmTexCoords0 = 2,
    pmTexCoords1 = 4,
    pmColours = 8,
    pmQuantised = 16,
};

/// Returns the check sum of a whole section, from its letters on.
std::uint32_t pmCheckSum(std::string_view bytes);

class PmByteWriter
{
public:
    template<class Number>
    void put(Number number)
    {
        std::array<char, sizeof(Number)> bytes{};
        std::memcpy(bytes.data(), &number, sizeof number);
        if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
        _bytes.append(bytes.data(), bytes.size());
    }
    void put(std::string_view text)
    {
        put(static_cast<std::uint32_t>(text.size()));
        _bytes.append(text);
    }
    void append(std::string_view bytes) { _bytes.append(bytes); }

    const std::string& bytes() const { return _bytes; }

private:
    std::string _bytes;
};

/// Reads numbers and text. Beyond the end it returns 0, and isGood() becomes false.
class PmByteReader
{
public:
    explicit PmByteReader(std::string_view bytes) : _bytes(bytes) {}

    template<class Number>
    Number get()
    {
        const std::string_view from = take(sizeof(Number));
        std::array<char, sizeof(Number)> bytes{};
        std::copy(from.begin(), from.end(), bytes.begin());
        if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
        Number number{};
        std::memcpy(&number, bytes.data(), sizeof number);
        return number;
    }
    std::string text() { return std::string(take(get<std::uint32_t>())); }

    std::string_view rest() { return take(_bytes.size()); }

    std::string_view take(std::size_t count)
    {
        if (count > _bytes.size())
        {
            _isGood = false;
            count = 0;
        }
        const std::string_view taken = _bytes.substr(0, count);
        _bytes.remove_prefix(count);
        return taken;
    }

    /// Tells whether `count` items of `bytesEach` bytes can follow; ask before allocating memory for them.
    bool hasRoomFor(std::uint64_t count, std::size_t bytesEach)
    {
        if (count * bytesEach > _bytes.size()) _isGood = false;
        return _isGood;
    }

    bool isGood() const { return _isGood; }
    bool isAtEnd() const { return _bytes.empty(); }

private:
    std::string_view _bytes;
    bool _isGood = true;
};

} // namespace osgPMObjects::core
