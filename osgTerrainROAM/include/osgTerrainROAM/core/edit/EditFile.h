// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace osgTerrainROAM::core
{

/// Writes what edits have made of a tile: heights, errors, radii and culling bounds, of the points where they
/// are no longer those of `before`.
/// `before`: the same tile, without edits. `source`: a mark of what the edits were made from (markOf()),
/// which readEdits() compares.
/// Format: little-endian; a header with the mark of `before`, then points and chunks of points as they are
/// kept, then a sum of all bytes.
/// Size: some 13 B for each sample that edits have put. Errors: tiles that are not of one grid; a file that
/// cannot be written.
foundation::Outcome writeEdits(const RoamTile& before, const RoamTile& edited, std::uint64_t source,
                               const std::filesystem::path& file);

/// Gives a tile that nobody has edited or shown the state that writeEdits() has kept, bit by bit: bounds need
/// not be measured again.
/// Cost: some 0.1 µs a point. Errors, each before anything is changed: a file that is none, is damaged, or
/// was made by another version, for another tile, or from another source.
foundation::Outcome readEdits(RoamTile& tile, std::uint64_t source, const std::filesystem::path& file);

/// A mark of bytes: other bytes have another one, but for one chance in 2^64. No protection against intent.
/// Method: FNV-1a over words of 8 B. Source: Fowler, Noll & Vo, *The FNV non-cryptographic hash algorithm*,
/// IETF draft, 2012.
std::uint64_t markOf(std::string_view bytes, std::uint64_t start = 0xcbf29ce484222325u);

} // namespace osgTerrainROAM::core
