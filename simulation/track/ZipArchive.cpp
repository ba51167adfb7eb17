// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/ZipArchive.h"

#include <algorithm>
#include <cstring>

#include <zlib.h>

namespace simulation
{
namespace
{

constexpr std::size_t kLocalBytes = 30, kEntryBytes = 46, kEndBytes = 22; ///< of headers without names

/// A little-endian number of so many bytes.
std::size_t number(std::string_view bytes, std::size_t at, int count)
{
    std::size_t value = 0;
    for (int i = count; i-- > 0;)
        value = value << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]);
    return value;
}

/// A file of an archive, as its directory has it.
struct ZipEntry
{
    std::string_view name;
    std::size_t flags = 0, method = 0, checksum = 0, packedBytes = 0, begin = 0;
};

std::optional<ZipEntry> bestEntry(std::string_view zip, const std::function<int(std::string_view)>& rank)
{
    const std::size_t end = zip.rfind("PK\x05\x06");
    if (end == std::string_view::npos || end + kEndBytes > zip.size()) return std::nullopt;
    std::size_t at = number(zip, end + 16, 4);
    std::optional<ZipEntry> best;
    int bestRank = 0;
    for (std::size_t left = number(zip, end + 10, 2);
         left > 0 && at < zip.size() && zip.substr(at).starts_with("PK\x01\x02") &&
         at + kEntryBytes <= zip.size();
         --left)
    {
        const ZipEntry entry{zip.substr(at + kEntryBytes, number(zip, at + 28, 2)),
                             number(zip, at + 8, 2),
                             number(zip, at + 10, 2),
                             number(zip, at + 16, 4),
                             number(zip, at + 20, 4),
                             number(zip, at + 42, 4)};
        at += kEntryBytes + number(zip, at + 28, 2) + number(zip, at + 30, 2) + number(zip, at + 32, 2);
        if (entry.name.ends_with('/') || (best && rank(entry.name) >= bestRank)) continue;
        best = entry;
        bestRank = rank(entry.name);
    }
    return best;
}

/// The first file of an archive without a directory.
std::optional<ZipEntry> firstEntry(std::string_view zip)
{
    if (zip.size() < kLocalBytes || !zip.starts_with("PK\x03\x04")) return std::nullopt;
    return ZipEntry{{}, number(zip, 6, 2), number(zip, 8, 2), 0, number(zip, 18, 4), 0};
}

} // namespace

std::optional<std::string> inflated(std::string_view bytes, int windowBits)
{
    z_stream stream;
    std::memset(&stream, 0, sizeof stream);
    if (inflateInit2(&stream, windowBits) != Z_OK) return std::nullopt;
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    std::string text;
    int status = Z_OK;
    while (status == Z_OK && text.size() <= kMostUnpackedBytes)
    {
        constexpr std::size_t kPiece = 1 << 16;
        const std::size_t before = text.size();
        text.resize(before + kPiece);
        stream.next_out = reinterpret_cast<Bytef*>(text.data() + before);
        stream.avail_out = kPiece;
        status = inflate(&stream, Z_NO_FLUSH);
        text.resize(before + kPiece - stream.avail_out);
    }
    inflateEnd(&stream);
    if (status != Z_STREAM_END) return std::nullopt;
    return text;
}

std::optional<std::string> fileOfZip(std::string_view zip, const std::function<int(std::string_view)>& rank)
{
    constexpr std::size_t kEncrypted = 1;
    std::optional<ZipEntry> entry = bestEntry(zip, rank);
    const bool hasDirectory = entry.has_value();
    if (!entry) entry = firstEntry(zip);
    if (!entry || entry->flags & kEncrypted || entry->begin + kLocalBytes > zip.size()) return std::nullopt;
    const std::size_t begin =
        entry->begin + kLocalBytes + number(zip, entry->begin + 26, 2) + number(zip, entry->begin + 28, 2);
    if (begin > zip.size() || (hasDirectory && entry->packedBytes > zip.size() - begin)) return std::nullopt;
    const std::string_view packed =
        zip.substr(begin, hasDirectory ? entry->packedBytes : std::string_view::npos);
    std::optional<std::string> text;
    if (entry->method == Z_DEFLATED)
        text = inflated(packed, -MAX_WBITS);
    else if (entry->method == 0 && entry->packedBytes > 0 && entry->packedBytes <= packed.size())
        text = std::string(packed.substr(0, entry->packedBytes));
    if (text && hasDirectory &&
        crc32(0, reinterpret_cast<const Bytef*>(text->data()), static_cast<uInt>(text->size())) !=
            entry->checksum)
        return std::nullopt;
    return text;
}

} // namespace simulation
