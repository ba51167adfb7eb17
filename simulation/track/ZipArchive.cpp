// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/ZipArchive.h"

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

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

/// The files of the archive's directory whose rank is not below 0, by their ranks. Absent: it has no
/// directory.
std::optional<std::vector<ZipEntry>> entriesOf(std::string_view zip,
                                               const std::function<int(std::string_view)>& rank)
{
    const std::size_t end = zip.rfind("PK\x05\x06");
    if (end == std::string_view::npos || end + kEndBytes > zip.size()) return std::nullopt;
    std::size_t at = number(zip, end + 16, 4);
    std::vector<ZipEntry> entries;
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
        if (!entry.name.ends_with('/') && rank(entry.name) >= 0) entries.push_back(entry);
    }
    std::stable_sort(entries.begin(), entries.end(),
                     [&](const ZipEntry& a, const ZipEntry& b) { return rank(a.name) < rank(b.name); });
    return entries;
}

/// The first file of an archive without a directory.
std::optional<ZipEntry> firstEntry(std::string_view zip)
{
    if (zip.size() < kLocalBytes || !zip.starts_with("PK\x03\x04")) return std::nullopt;
    return ZipEntry{{}, number(zip, 6, 2), number(zip, 8, 2), 0, number(zip, 18, 4), 0};
}

/// `isWhole`: the sizes and the checksum are those of the directory.
ZipFile unpacked(std::string_view zip, const ZipEntry& entry, bool isWhole)
{
    constexpr std::size_t kEncrypted = 1;
    const auto refused = [&](const char* reason) {
        return ZipFile{std::string(entry.name), std::nullopt, reason};
    };
    if (entry.flags & kEncrypted) return refused("is encrypted");
    if (entry.method != 0 && entry.method != Z_DEFLATED)
        return refused("is packed by a method that is not read");
    if (entry.begin + kLocalBytes > zip.size()) return refused("is in a damaged zip archive");
    const std::size_t begin =
        entry.begin + kLocalBytes + number(zip, entry.begin + 26, 2) + number(zip, entry.begin + 28, 2);
    if (begin > zip.size() || (isWhole && entry.packedBytes > zip.size() - begin))
        return refused("is in a damaged zip archive");
    const std::string_view packed = zip.substr(begin, isWhole ? entry.packedBytes : std::string_view::npos);
    std::optional<std::string> text;
    if (entry.method == Z_DEFLATED)
        text = inflated(packed, -MAX_WBITS);
    else if (entry.packedBytes > 0 && entry.packedBytes <= packed.size())
        text = std::string(packed.substr(0, entry.packedBytes));
    if (text && isWhole &&
        crc32(0, reinterpret_cast<const Bytef*>(text->data()), static_cast<uInt>(text->size())) !=
            entry.checksum)
        text.reset();
    if (!text) return refused("is in a damaged zip archive");
    return {std::string(entry.name), std::move(text), {}};
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

void forEachFileOfZip(std::string_view zip, const std::function<int(std::string_view)>& rank,
                      const std::function<bool(ZipFile)>& use)
{
    const auto entries = entriesOf(zip, rank);
    if (entries)
    {
        for (const ZipEntry& entry : *entries)
            if (use(unpacked(zip, entry, true))) return;
        return;
    }
    if (const auto first = firstEntry(zip)) use(unpacked(zip, *first, false));
}

} // namespace simulation
