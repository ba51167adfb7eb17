// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
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
    std::uint32_t version = 0, trees = 0, directorySum = 0, headerSum = 0;
    reader.take(version);
    if (version != kMtVersion)
        return failure("is of version " + std::to_string(version) + ", this program reads version " +
                       std::to_string(kMtVersion));
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
    return foundation::success();
}

foundation::Result<ReadTree> MtFile::read(std::uint32_t tree, const ReadTree* parent,
                                          std::size_t fragments) const
{
    const std::string name = "tree " + std::to_string(tree);
    const MtEntry& entry = _info.trees[tree];
    std::error_code code;
    if (entry.offset + entry.bytes > std::filesystem::file_size(_file, code) || code)
        return failure("ends before " + name + " does");
    std::vector<std::byte> bytes(entry.bytes);
    std::ifstream stream(_file, std::ios::binary);
    stream.seekg(static_cast<std::streamoff>(entry.offset));
    const std::span<char> chars(reinterpret_cast<char*>(bytes.data()), bytes.size());
    if (!stream.read(chars.data(), static_cast<std::streamsize>(chars.size())))
        return failure(name + " cannot be read");
    if (mtChecksum(chars) != entry.checksum) return failure(name + " is damaged: its checksum differs");
    auto record = decodeTree(bytes, _info.heightStep, fragments);
    if (!record) return failure(name + " is no tree");
    ReadTree read{{std::move(record->part), entry.parent, {}}, std::move(record->childRoots)};
    if (tree == 0) return read;
    const std::span<const std::uint32_t> siblings = childrenOf(entry.parent);
    const auto place =
        static_cast<std::size_t>(std::lower_bound(siblings.begin(), siblings.end(), tree) - siblings.begin());
    if (!parent || place >= parent->childRoots.size()) return failure(name + " has no place in its parent");
    const std::vector<std::uint32_t>& roots = parent->childRoots[place];
    bool fits = roots.size() == read.tree.part.rootTriangles;
    for (std::uint32_t t = 0; fits && t < roots.size(); ++t)
        fits = isSameRoot(read.tree.part, t, parent->tree.part, roots[t]);
    if (!fits) return failure(name + " does not fit its parent");
    read.tree.parentTriangles = roots;
    return read;
}

} // namespace osgMultiTriangulation::core
