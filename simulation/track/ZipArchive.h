// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace simulation
{

/// The most bytes that compressed data may hold.
inline constexpr std::size_t kMostUnpackedBytes = std::size_t{256} << 20;

/// Returns what a compressed stream holds. `windowBits`: as of zlib's inflateInit2(). Nothing where it is
/// damaged or holds more than kMostUnpackedBytes.
std::optional<std::string> inflated(std::string_view bytes, int windowBits);

/// A file of a zip archive.
struct ZipFile
{
    std::string name;                ///< empty: the archive's directory was cut off
    std::optional<std::string> text; ///< nothing: it cannot be unpacked
    std::string reason;              ///< why not: "is encrypted"
};

/// Returns the files of a zip archive whose rank is not below 0, those of the smallest rank first, of equal
/// ones as its directory has them. Of an archive whose directory was cut off the first file is returned.
/// Empty: there is none. Each is unpacked when the one before has been looked at: `use` returns true to end
/// it.
/// Source: PKWARE, *.ZIP file format specification* 6.3.10, 4.3.7 (local file header), 4.3.12 (central
/// directory structure), 4.3.16 (end of central directory record).
void forEachFileOfZip(std::string_view zip, const std::function<int(std::string_view name)>& rank,
                      const std::function<bool(ZipFile)>& use);

} // namespace simulation
