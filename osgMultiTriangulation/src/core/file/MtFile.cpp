// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>

#include <zlib.h>

#include <osgMultiTriangulation/core/file/MtFile.h>

#include "MtHeader.h"

namespace osgMultiTriangulation::core
{

namespace
{

/// Whether an entry can be true, so that nothing is reserved or read for one that cannot.
bool isPlausible(const MtEntry& entry, std::uint32_t number)
{
    if ((number == 0) != (entry.parent == kNone) || (number > 0 && entry.parent >= number)) return false;
    for (int axis = 0; axis < 2; ++axis)
        if (entry.low[axis] < 0 || entry.low[axis] > entry.high[axis] || entry.high[axis] > kMostPlan)
            return false;
    return entry.rootError >= 0.0f && entry.bytes < (1u << 31);
}

/// Whether two trees mean the same triangle, from whichever corner on.
bool isSameRoot(const MultiTriangulation& child, std::uint32_t root, const MultiTriangulation& parent,
                std::uint32_t triangle)
{
    const Triangle &own = child.corners[root], &above = parent.corners[triangle];
    for (int turn = 0; turn < 3; ++turn)
    {
        bool isSame = true;
        for (int c = 0; c < 3; ++c)
            isSame = isSame && child.points[own[c]] == parent.points[above[(c + turn) % 3]];
        if (isSame) return true;
    }
    return false;
}

std::uint32_t checksumOf(std::span<const std::byte> bytes)
{
    return mtChecksum({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

/// Adds a section to a tree. `wanted`: how many fragments it shall have. Returns whether it fits.
bool decodeSection(std::span<const std::byte> bytes, double heightStep, const MtEntry& entry,
                   std::uint32_t section, std::uint32_t wanted, TreeRecord& record)
{
    MultiTriangulation& part = record.part;
    if (section == 0)
    {
        std::uint32_t fragments = 0;
        return decodeRoot(bytes, heightStep, part, fragments) && fragments == entry.fragments &&
               part.rootTriangles > 0;
    }
    if (section + 1 == sectionsFor(entry.fragments)) return decodeTies(bytes, record);
    reserveFragments(part, wanted);
    const auto now = static_cast<std::uint32_t>(part.fragments.size());
    return decodeFragments(bytes, heightStep, std::min(kSectionFragments, wanted - now), part);
}

} // namespace

std::uint32_t mtChecksum(std::span<const char> bytes)
{
    return static_cast<std::uint32_t>(
        crc32_z(0, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

foundation::Error MtFile::failure(const std::string& what) const
{
    return {_file.string(), what, "build it anew with terraintool mt-build"};
}

foundation::Result<MtFile> MtFile::open(const std::filesystem::path& path)
{
    MtFile file;
    file._file = path;
    std::ifstream stream(path, std::ios::binary);
    if (!stream)
        return foundation::Error{path.string(), "cannot be opened", "check the path and its permissions"};
    char header[kMtHeaderBytes];
    if (!stream.read(header, sizeof header) || std::memcmp(header, kMtMagic, sizeof kMtMagic) != 0)
        return foundation::Error{path.string(), "is not a .mt file",
                                 "name one that terraintool mt-build wrote"};
    if (const auto outcome = file.readDirectory({header, sizeof header}); !outcome) return outcome.error();
    return file;
}

foundation::Outcome MtFile::readDirectory(std::span<const char> header)
{
    LittleEndianReader reader(header.data() + sizeof kMtMagic);
    std::uint32_t trees = 0, directorySum = 0, headerSum = 0;
    reader.take(_version);
    if (_version < kMtOldestVersion || _version > kMtVersion)
        return failure("is of version " + std::to_string(_version) + ", this program reads versions " +
                       std::to_string(kMtOldestVersion) + " to " + std::to_string(kMtVersion));
    reader.take(trees);
    for (double* value : {&_info.frame.originX, &_info.frame.originY, &_info.frame.stepX, &_info.frame.stepY,
                          &_info.heightStep})
        reader.take(*value);
    reader.take(_info.points);
    reader.take(_info.triangles);
    reader.take(directorySum);
    reader.take(headerSum);
    if (headerSum != mtChecksum(header.first(kMtHeaderBytes - 4))) return failure("has a damaged header");
    std::error_code code;
    const std::uintmax_t size = std::filesystem::file_size(_file, code);
    if (code || trees == 0 || size < kMtHeaderBytes + std::uint64_t(trees) * kMtEntryBytes)
        return failure("ends within its directory");
    std::string directory(trees * kMtEntryBytes, '\0');
    std::ifstream stream(_file, std::ios::binary);
    stream.seekg(kMtHeaderBytes);
    if (!stream.read(directory.data(), static_cast<std::streamsize>(directory.size())))
        return failure("ends within its directory");
    if (directorySum != mtChecksum(directory)) return failure("has a damaged directory");
    _children.resize(trees);
    for (std::uint32_t t = 0; t < trees; ++t)
    {
        MtEntry entry;
        LittleEndianReader fields(directory.data() + std::size_t(t) * kMtEntryBytes);
        visitFields(entry, [&](auto& field) { fields.take(field); });
        if (!isPlausible(entry, t))
            return failure("has a directory that cannot be true at tree " + std::to_string(t));
        if (t > 0) _children[entry.parent].push_back(t);
        _info.trees.push_back(entry);
    }
    return _version < kMtVersion ? foundation::success() : readReference(stream);
}

/// Reads where the plan lies, which stands behind the directory.
foundation::Outcome MtFile::readReference(std::istream& stream)
{
    std::string bytes(kMtReferenceBytes - 4, '\0');
    std::uint32_t length = 0, sum = 0;
    const auto read = [&](std::size_t from)
    { return bool(stream.read(bytes.data() + from, static_cast<std::streamsize>(bytes.size() - from))); };
    if (!read(0)) return failure("ends within its reference system");
    PlanReference at;
    LittleEndianReader fields(bytes.data());
    fields.take(length);
    for (double* value : {&at.firstX, &at.firstY, &at.stepX, &at.stepY})
        fields.take(*value);
    if (length > kMostMtReferenceText) return failure("has a damaged reference system");
    bytes.resize(kMtReferenceBytes + length);
    if (!read(kMtReferenceBytes - 4)) return failure("ends within its reference system");
    LittleEndianReader(bytes.data() + bytes.size() - 4).take(sum);
    bytes.resize(bytes.size() - 4);
    const bool isPlace = std::isfinite(at.firstX) && std::isfinite(at.firstY) && at.stepX > 0.0 &&
                         at.stepY > 0.0 && std::isfinite(at.stepX) && std::isfinite(at.stepY);
    if (sum != mtChecksum(bytes) || !isPlace) return failure("has a damaged reference system");
    at.system = bytes.substr(kMtReferenceBytes - 4);
    _info.frame.reference = std::move(at);
    return foundation::success();
}

foundation::Result<std::vector<std::byte>> MtFile::bytesAt(std::uint32_t tree, std::uint64_t offset,
                                                           std::size_t count) const
{
    std::error_code code;
    if (offset + count > std::filesystem::file_size(_file, code) || code)
        return failure("ends before tree " + std::to_string(tree) + " does");
    std::vector<std::byte> bytes(count);
    std::ifstream stream(_file, std::ios::binary);
    stream.seekg(static_cast<std::streamoff>(offset));
    if (!stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(count)))
        return failure("tree " + std::to_string(tree) + " cannot be read");
    return bytes;
}

foundation::Result<std::vector<TreeSection>> MtFile::sectionsOf(std::uint32_t tree) const
{
    const MtEntry& entry = _info.trees[tree];
    const std::size_t length = sectionTableBytes(entry.fragments);
    const std::string damage = "tree " + std::to_string(tree) + " is damaged: ";
    if (length > entry.bytes) return failure(damage + "it is shorter than its table");
    const auto table = bytesAt(tree, entry.offset, length);
    if (!table) return table.error();
    if (checksumOf(*table) != entry.checksum) return failure(damage + "the checksum of its table differs");
    auto sections = readSectionTable(*table, entry.bytes);
    if (!sections || sections->size() != sectionsFor(entry.fragments))
        return failure(damage + "its table does not fit it");
    return std::move(*sections);
}

foundation::Outcome MtFile::readSections(std::uint32_t tree, ReadTree& read, std::size_t most) const
{
    const MtEntry& entry = _info.trees[tree];
    const auto sections = sectionsOf(tree);
    if (!sections) return sections.error();
    MultiTriangulation& part = read.tree.part;
    const auto wanted = static_cast<std::uint32_t>(wholeSections(entry.fragments, most));
    const auto now = static_cast<std::uint32_t>(part.fragments.size());
    if (wanted < now) return foundation::success();
    const std::uint32_t first = part.rootTriangles > 0 ? sectionsFor(now) - 1 : 0;
    const std::uint32_t end = wanted == entry.fragments ? sectionsFor(wanted) : sectionsFor(wanted) - 1;
    std::uint64_t offset = entry.offset + sectionTableBytes(entry.fragments);
    for (std::uint32_t s = 0; s < first; ++s)
        offset += (*sections)[s].bytes;
    std::size_t count = 0;
    for (std::uint32_t s = first; s < end; ++s)
        count += (*sections)[s].bytes;
    const auto bytes = bytesAt(tree, offset, count);
    if (!bytes) return bytes.error();
    read.readBytes += sectionTableBytes(entry.fragments) + count;
    std::span<const std::byte> left = *bytes;
    TreeRecord record{std::move(part), {}};
    bool isTree = true, isWhole = true;
    for (std::uint32_t s = first; s < end && isTree && isWhole; ++s)
    {
        const std::span<const std::byte> own = left.first((*sections)[s].bytes);
        left = left.subspan(own.size());
        isWhole = checksumOf(own) == (*sections)[s].checksum;
        if (isWhole) isTree = decodeSection(own, _info.heightStep, entry, s, wanted, record);
    }
    read.tree.part = std::move(record.part);
    read.childRoots = std::move(record.childRoots);
    const std::string name = "tree " + std::to_string(tree);
    if (!isWhole) return failure(name + " is damaged: the checksum of a section differs");
    if (!isTree) return failure(name + " is no tree");
    return foundation::success();
}

/// Reads a tree of version 1, or as much of it anew.
foundation::Outcome MtFile::readWhole(std::uint32_t tree, ReadTree& read, std::size_t fragments) const
{
    const MtEntry& entry = _info.trees[tree];
    const auto bytes = bytesAt(tree, entry.offset, entry.bytes);
    if (!bytes) return bytes.error();
    read.readBytes += entry.bytes;
    const std::string name = "tree " + std::to_string(tree);
    if (checksumOf(*bytes) != entry.checksum) return failure(name + " is damaged: its checksum differs");
    auto record = decodeWholeTree(*bytes, _info.heightStep, fragments);
    if (!record) return failure(name + " is no tree");
    read.tree.part = std::move(record->part);
    read.childRoots = std::move(record->childRoots);
    return foundation::success();
}

foundation::Result<ReadTree> MtFile::read(std::uint32_t tree, const ReadTree* parent,
                                          std::size_t fragments) const
{
    ReadTree read{{{}, _info.trees[tree].parent, {}}, {}};
    if (const auto outcome = readMore(tree, read, fragments); !outcome) return outcome.error();
    if (const auto outcome = tieToParent(tree, parent, read); !outcome) return outcome.error();
    return read;
}

foundation::Outcome MtFile::readMore(std::uint32_t tree, ReadTree& read, std::size_t fragments) const
{
    return _version == 1 ? readWhole(tree, read, fragments) : readSections(tree, read, fragments);
}

std::uint32_t MtFile::soundFragments(std::uint32_t tree) const
{
    if (_version == 1) return 0;
    const auto sections = sectionsOf(tree);
    if (!sections) return 0;
    const MtEntry& entry = _info.trees[tree];
    std::uint64_t offset = entry.offset + sectionTableBytes(entry.fragments);
    std::uint32_t sound = 0;
    for (; sound < sections->size(); ++sound)
    {
        const auto bytes = bytesAt(tree, offset, (*sections)[sound].bytes);
        if (!bytes || checksumOf(*bytes) != (*sections)[sound].checksum) break;
        offset += bytes->size();
    }
    if (sound == sections->size()) return entry.fragments;
    // Without its ties a tree is not complete: its last section counts as damaged, too.
    if (sound + 1 == sections->size() && sound > 1) --sound;
    return sound < 2 ? 0 : (sound - 1) * kSectionFragments;
}

/// Finds the triangles of a tree's root in its parent. Errors: they do not fit.
foundation::Outcome MtFile::tieToParent(std::uint32_t tree, const ReadTree* parent, ReadTree& read) const
{
    if (tree == 0) return foundation::success();
    const std::string name = "tree " + std::to_string(tree);
    const std::span<const std::uint32_t> siblings = childrenOf(_info.trees[tree].parent);
    const auto place =
        static_cast<std::size_t>(std::lower_bound(siblings.begin(), siblings.end(), tree) - siblings.begin());
    if (!parent || place >= parent->childRoots.size()) return failure(name + " has no place in its parent");
    const std::vector<std::uint32_t>& roots = parent->childRoots[place];
    bool fits = roots.size() == read.tree.part.rootTriangles;
    for (std::uint32_t t = 0; fits && t < roots.size(); ++t)
        fits = isSameRoot(read.tree.part, t, parent->tree.part, roots[t]);
    if (!fits) return failure(name + " does not fit its parent");
    read.tree.parentTriangles = roots;
    return foundation::success();
}

} // namespace osgMultiTriangulation::core
