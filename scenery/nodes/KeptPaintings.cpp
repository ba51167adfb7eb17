// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/KeptPaintings.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

#include <foundation/KeptResults.h>

#include "scenery/models/Paint.h"
#include "scenery/models/paint/MipChain.h"
#include "scenery/models/vehicles/VehicleLook.h"

namespace scenery
{

namespace
{

using models::Picture;
using Sides = std::array<std::uint32_t, 2>;

/// The sides of the first level, then the pixels of all.
std::string bytesOfChain(const std::vector<Picture>& chain)
{
    const Sides sides{static_cast<std::uint32_t>(chain.front().widthPx),
                      static_cast<std::uint32_t>(chain.front().heightPx)};
    std::string bytes(reinterpret_cast<const char*>(sides.data()), sizeof sides);
    for (const Picture& level : chain)
        bytes.append(reinterpret_cast<const char*>(level.rgba.data()), level.rgba.size());
    return bytes;
}

/// Absent: they are not what bytesOfChain() wrote.
std::optional<std::vector<Picture>> chainIn(std::string_view bytes)
{
    constexpr std::uint32_t kMostSide = 16384;
    Sides sides{};
    if (bytes.size() < sizeof sides) return std::nullopt;
    std::memcpy(sides.data(), bytes.data(), sizeof sides);
    for (const std::uint32_t side : sides)
        if (side > kMostSide || !std::has_single_bit(side)) return std::nullopt;
    std::vector<Picture> chain;
    std::size_t at = sizeof sides;
    while (true)
    {
        const std::size_t size = std::size_t{4} * sides[0] * sides[1];
        if (bytes.size() - at < size) return std::nullopt;
        Picture& level = chain.emplace_back();
        level.widthPx = static_cast<int>(sides[0]);
        level.heightPx = static_cast<int>(sides[1]);
        level.rgba.assign(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                          bytes.begin() + static_cast<std::ptrdiff_t>(at + size));
        at += size;
        if (sides == Sides{1, 1}) break;
        for (std::uint32_t& side : sides)
            side = std::max(1U, side / 2);
    }
    return at == bytes.size() ? std::optional(std::move(chain)) : std::nullopt;
}

} // namespace

std::vector<Picture> paintedChain(models::Painting painting, bool isFoliage,
                                  const foundation::KeptResults& kept, const models::VehicleLook* look)
{
    foundation::ContentMark mark;
    mark.addWord(static_cast<std::uint64_t>(painting)).addWord(isFoliage ? 1U : 0U);
    if (look) mark.add(look->mark.text());
    return kept.findOrMake(
        "painting", mark, chainIn, [&] { return models::mipChain(models::paint(painting, look), isFoliage); },
        bytesOfChain);
}

} // namespace scenery
