// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cerrno>
#include <fstream>

#include <foundation/WholeFile.h>

#include <osgMultiTriangulation/core/file/MtFile.h>

#include "MtHeader.h"

namespace osgMultiTriangulation::core
{

namespace
{

std::string headerOf(const MtInfo& info, std::span<const MtEntry> entries, const std::string& directory)
{
    std::string header(kMtMagic, sizeof kMtMagic);
    LittleEndian out(header);
    out.add(info.frame.reference ? kMtVersion : kMtVersionWithoutReference);
    out.add(static_cast<std::uint32_t>(entries.size()));
    for (const double value :
         {info.frame.originX, info.frame.originY, info.frame.stepX, info.frame.stepY, info.heightStep})
        out.add(value);
    out.add(info.points);
    out.add(info.triangles);
    out.add(mtChecksum(directory));
    out.add(mtChecksum(header));
    return header;
}

/// Returns the place of the plan in a reference system as bytes; none where there is none.
std::string referenceBlock(const PlanFrame& frame)
{
    if (!frame.reference) return {};
    const PlanReference& at = *frame.reference;
    std::string bytes;
    LittleEndian out(bytes);
    out.add(static_cast<std::uint32_t>(at.system.size()));
    for (const double value : {at.firstX, at.firstY, at.stepX, at.stepY})
        out.add(value);
    bytes += at.system;
    out.add(mtChecksum(bytes));
    return bytes;
}

} // namespace

EncodedTree encodedTree(const TreeRecord& record, std::uint32_t parent, double heightStep)
{
    const MultiTriangulation& tree = record.part;
    EncodedTree encoded{{}, encodeTree(record, heightStep)};
    MtEntry& entry = encoded.entry;
    entry.bytes = static_cast<std::uint32_t>(encoded.bytes.size());
    const std::size_t table = sectionTableBytes(static_cast<std::uint32_t>(record.part.fragments.size()));
    entry.checksum = mtChecksum({reinterpret_cast<const char*>(encoded.bytes.data()), table});
    entry.parent = parent;
    entry.points = static_cast<std::uint32_t>(tree.points.size());
    entry.triangles = tree.triangleCount();
    entry.fragments = static_cast<std::uint32_t>(tree.fragments.size());
    entry.rootTriangles = tree.rootTriangles;
    for (std::uint32_t t = 0; t < tree.rootTriangles; ++t)
        entry.rootError = std::max(entry.rootError, tree.errors[t]);
    for (std::size_t p = 0; p < tree.points.size(); ++p)
    {
        const std::int32_t at[2] = {tree.points[p].x, tree.points[p].y};
        for (int axis = 0; axis < 2; ++axis)
        {
            entry.low[axis] = p == 0 ? at[axis] : std::min(entry.low[axis], at[axis]);
            entry.high[axis] = p == 0 ? at[axis] : std::max(entry.high[axis], at[axis]);
        }
    }
    return encoded;
}

foundation::Outcome
writeMtFile(const std::filesystem::path& path, const MtInfo& info, std::vector<MtEntry> entries,
            const std::function<foundation::Result<std::vector<std::byte>>(std::uint32_t)>& bytesOf)
{
    std::string directory;
    LittleEndian out(directory);
    const std::string reference = referenceBlock(info.frame);
    std::uint64_t offset = kMtHeaderBytes + entries.size() * kMtEntryBytes + reference.size();
    for (MtEntry& entry : entries)
    {
        entry.offset = offset;
        offset += entry.bytes;
        visitFields(entry, [&](const auto& field) { out.add(field); });
    }
    foundation::WholeFile file(path);
    const auto reason = [] { return std::generic_category().message(errno); };
    errno = 0;
    std::ofstream stream(file.written(), std::ios::binary);
    if (!stream) return file.failure("cannot be created", reason());
    stream << headerOf(info, entries, directory) << directory << reference;
    for (std::uint32_t t = 0; t < entries.size(); ++t)
    {
        const auto bytes = bytesOf(t);
        if (!bytes) return bytes.error();
        stream.write(reinterpret_cast<const char*>(bytes->data()),
                     static_cast<std::streamsize>(bytes->size()));
    }
    stream.close();
    if (!stream) return file.failure("cannot be written", reason());
    return file.commit();
}

} // namespace osgMultiTriangulation::core
