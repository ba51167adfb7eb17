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

/// Returns the file of a zip archive of which `rank` gives the smallest number, of equal ones the first of
/// its directory. Of an archive whose directory was cut off the first file is returned. Nothing where that
/// file is damaged, encrypted or too large, or there is none.
/// Source: PKWARE, *.ZIP file format specification* 6.3.10, 4.3.7 (local file header), 4.3.12 (central
/// directory structure), 4.3.16 (end of central directory record).
std::optional<std::string> fileOfZip(std::string_view zip,
                                     const std::function<int(std::string_view name)>& rank);

} // namespace simulation
