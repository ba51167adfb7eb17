// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace osgPMObjects::core
{

/// The corners of a box's outline as the eye sees it, counter-clockwise. Bit a of a corner's number is set if
/// the corner lies on the positive side of axis a.
struct BoxOutline
{
    std::uint8_t count =
        0; ///< 4: one visible face; 6: two or three; 0: the eye is inside, or the code is not a region
    std::array<std::uint8_t, 6> corners{};

    bool operator==(const BoxOutline&) const = default;
};

/// The number of region codes. A code tells on which sides of a box the eye is: bit 2a is set below the
/// negative side of axis a, bit 2a + 1 above its positive side. Both are never set at once, so the largest
/// code is 42.
inline constexpr std::uint32_t kBoxRegions = 43;

namespace detail
{

/// Builds an outline: the edges of the visible faces without those that two visible faces share.
constexpr BoxOutline boxOutline(std::uint32_t region)
{
    constexpr std::uint8_t kNone = 8;
    bool edge[8][8] = {};
    for (std::uint32_t axis = 0; axis < 3; ++axis)
    {
        if ((region >> 2 * axis & 3u) == 3u) return {};
        for (std::uint32_t side = 0; side < 2; ++side)
        {
            if (!(region >> (2 * axis + side) & 1u)) continue;
            const std::uint32_t u = 1u << (axis + 1) % 3, v = 1u << (axis + 2) % 3, on = side << axis;
            const std::uint32_t loop[4] = {on, on | u, on | u | v, on | v};
            for (std::uint32_t i = 0; i < 4; ++i)
            {
                const std::uint32_t from = loop[i], to = loop[(i + 1) % 4];
                (side == 1 ? edge[from][to] : edge[to][from]) = true;
            }
        }
    }
    std::uint8_t next[8] = {kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone};
    std::uint8_t corner = kNone;
    for (std::uint8_t from = 0; from < 8; ++from)
        for (std::uint8_t to = 0; to < 8; ++to)
            if (edge[from][to] && !edge[to][from])
            {
                next[from] = to;
                if (corner == kNone) corner = from;
            }
    BoxOutline outline;
    if (corner == kNone) return outline;
    for (const std::uint8_t first = corner; outline.count == 0 || corner != first; corner = next[corner])
        outline.corners[outline.count++] = corner;
    return outline;
}

constexpr std::array<BoxOutline, kBoxRegions> boxOutlines()
{
    std::array<BoxOutline, kBoxRegions> outlines;
    for (std::uint32_t region = 0; region < kBoxRegions; ++region)
        outlines[region] = boxOutline(region);
    return outlines;
}

} // namespace detail

/// The outline for each region code. 27 of the 43 codes occur: 6 with four corners, 20 with six, and the
/// inside.
/// Source: Schmalstieg & Tobler, "Fast projected area computation for three-dimensional bounding boxes"
/// (1999). Differs: the compiler computes the table from the visible faces; corners are numbered by the bits
/// of their sides.
inline constexpr std::array<BoxOutline, kBoxRegions> kBoxOutlines = detail::boxOutlines();

} // namespace osgPMObjects::core
