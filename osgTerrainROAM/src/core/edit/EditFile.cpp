// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include <foundation/MappedFile.h>
#include <foundation/PlainBytes.h>
#include <foundation/WholeFile.h>

#include <osgTerrainROAM/core/edit/EditFile.h>
#include <osgTerrainROAM/core/edit/TileEditor.h>

#include "TilePoints.h"

namespace osgTerrainROAM::core
{

namespace
{

using foundation::appendValue;
using foundation::ValueTaker;

constexpr std::string_view kName = "osgTrainer edits 1\n";

/// What a file begins with, after kName.
struct Header
{
    std::uint64_t tile = 0, source = 0; ///< marks
    std::uint64_t points = 0, chunks = 0, spheres = 0;
    double lowestM = 0.0; ///< HidingGround::lowestM
};

/// The state that a file keeps.
struct Content
{
    Header header;
    std::vector<PointState> points;
    std::vector<ChunkState> chunks;
    std::vector<RegionBounds::Sphere> spheres;
};

/// The same of a file that is read. Its chunks stay there: unpacked they are many times as large.
struct ReadContent
{
    Header header;
    std::vector<PointState> points;
    ValueTaker chunks{{}}; ///< where they begin
    bool areChunksSound = true;
    std::vector<RegionBounds::Sphere> spheres;
};

bool takePoint(ValueTaker& taker, PointState& point)
{
    std::uint8_t flags = 0;
    if (!taker.take(point.place.column) || !taker.take(point.place.row) || !taker.take(flags) ||
        !taker.take(point.bound) || !taker.take(point.inSheet))
        return false;
    point.isElsewhere = (flags & 1) != 0;
    point.isLoose = (flags & 2) != 0;
    return true;
}

bool takeChunk(ValueTaker& taker, ChunkState& chunk)
{
    std::array<std::uint64_t, ChunkState::kPoints / 64> mask{};
    if (!taker.take(chunk.place.column) || !taker.take(chunk.place.row) || !taker.take(mask)) return false;
    for (std::size_t slot = 0; slot < ChunkState::kPoints; ++slot)
        if ((mask[slot / 64] >> (slot % 64) & 1) != 0 && !taker.take(chunk.samples[slot])) return false;
    return true;
}

/// Calls `use` with each chunk. False: there are too few bytes.
template<class Use>
bool forEachChunk(ValueTaker& taker, std::uint64_t count, const Use& use)
{
    for (std::uint64_t i = 0; i < count; ++i)
    {
        ChunkState chunk;
        if (!takeChunk(taker, chunk)) return false;
        use(chunk);
    }
    return true;
}

// Whether values are such as edits leave.
bool isBound(const SampleTable::Sample& sample)
{
    return sample.errorM >= 0.0f && sample.radiusM >= 0.0f;
}
bool isHeight(float heightM)
{
    return !(std::abs(heightM) > TileEditor::kHighestM) || heightM == FineSamples::kOnSurface;
}
bool isSoundFor(const ChunkState& chunk, const RoamTile& tile)
{
    return chunk.isWithin(tile.tile.grid()) &&
           std::all_of(chunk.samples.begin(), chunk.samples.end(),
                       [](const auto& sample) { return isBound(sample) && isHeight(sample.heightM); });
}

/// `bytes`: how many there are; they bound what is reserved.
bool take(ValueTaker& taker, std::size_t bytes, const RoamTile& tile, ReadContent& content)
{
    constexpr std::size_t kPointBytes = sizeof(GridPoint) + 1 + 2 * sizeof(SampleTable::Sample);
    if (!taker.take(content.header)) return false;
    content.points.reserve(std::min<std::uint64_t>(content.header.points, bytes / kPointBytes));
    for (std::uint64_t i = 0; i < content.header.points; ++i)
        if (!takePoint(taker, content.points.emplace_back())) return false;
    content.chunks = taker;
    const auto judge = [&](const ChunkState& chunk)
    { content.areChunksSound = content.areChunksSound && isSoundFor(chunk, tile); };
    if (!forEachChunk(taker, content.header.chunks, judge)) return false;
    for (std::uint64_t i = 0; i < content.header.spheres; ++i)
        if (!taker.take(content.spheres.emplace_back())) return false;
    return taker.isEmpty();
}

std::string bytesOf(const Content& content)
{
    std::string bytes(kName);
    appendValue(bytes, content.header);
    for (const PointState& point : content.points)
    {
        appendValue(bytes, point.place.column);
        appendValue(bytes, point.place.row);
        appendValue(bytes, static_cast<std::uint8_t>((point.isElsewhere ? 1 : 0) | (point.isLoose ? 2 : 0)));
        appendValue(bytes, point.bound);
        appendValue(bytes, point.inSheet);
    }
    for (const ChunkState& chunk : content.chunks)
    {
        std::array<std::uint64_t, ChunkState::kPoints / 64> mask{};
        for (std::size_t slot = 0; slot < ChunkState::kPoints; ++slot)
            if (ChunkState::isKept(chunk.samples[slot])) mask[slot / 64] |= std::uint64_t{1} << (slot % 64);
        appendValue(bytes, chunk.place.column);
        appendValue(bytes, chunk.place.row);
        appendValue(bytes, mask);
        for (const auto& sample : chunk.samples)
            if (ChunkState::isKept(sample)) appendValue(bytes, sample);
    }
    for (const auto& sphere : content.spheres)
        appendValue(bytes, sphere);
    appendValue(bytes, markOf(bytes));
    return bytes;
}

/// Tells whether values are such as edits leave.
bool isSoundFor(const ReadContent& content, const RoamTile& tile)
{
    const auto isPoint = [&](const PointState& point)
    {
        return isInTree(tile, point.place) && isBound(point.bound) && isBound(point.inSheet) &&
               isHeight(point.bound.heightM) && isHeight(point.inSheet.heightM);
    };
    return content.areChunksSound && std::all_of(content.points.begin(), content.points.end(), isPoint) &&
           content.spheres.size() == tile.regions.spheres().size();
}

} // namespace

std::uint64_t markOf(std::string_view bytes, std::uint64_t start)
{
    constexpr std::uint64_t kPrime = 0x100000001b3u;
    std::uint64_t mark = start, word = 0;
    for (; bytes.size() >= sizeof(word); bytes.remove_prefix(sizeof(word)))
    {
        std::memcpy(&word, bytes.data(), sizeof(word));
        mark = (mark ^ word) * kPrime;
        mark ^= mark >> 32; // high bits of a word count in low ones, too
    }
    for (const char byte : bytes)
        mark = (mark ^ static_cast<unsigned char>(byte)) * kPrime;
    return mark;
}

foundation::Outcome writeEdits(const RoamTile& before, const RoamTile& edited, std::uint64_t source,
                               const std::filesystem::path& file)
{
    if (before.tile.grid().side() != edited.tile.grid().side())
        return foundation::Error{file.string(), "the tile before the edits has another grid",
                                 "load it as the edited one was loaded"};
    Content content;
    content.points = changedPoints(before, edited);
    content.chunks = chunksOf(edited);
    const auto spheres = edited.regions.spheres();
    content.spheres.assign(spheres.begin(), spheres.end());
    content.header = {markOfTile(before),    source,         content.points.size(),
                      content.chunks.size(), spheres.size(), edited.hidingGround.lowestM};
    return foundation::writeWholeFile(file, bytesOf(content));
}

foundation::Outcome readEdits(RoamTile& tile, std::uint64_t source, const std::filesystem::path& file)
{
    const auto refuse = [&](const char* what, const char* remedy = "make it again, or take its line out") {
        return foundation::Error{file.string(), what, remedy};
    };
    const auto mapped = foundation::MappedFile::open(file);
    if (!mapped) return mapped.error();
    mapped->fetchAll();
    std::string_view bytes = mapped->text();
    if (!bytes.starts_with(kName)) return refuse("holds no edits of a terrain that this version reads");
    std::uint64_t sum = 0;
    if (bytes.size() < kName.size() + sizeof(sum)) return refuse("is cut off");
    std::memcpy(&sum, bytes.data() + bytes.size() - sizeof(sum), sizeof(sum));
    bytes.remove_suffix(sizeof(sum));
    if (markOf(bytes) != sum) return refuse("is cut off or damaged");
    ValueTaker taker(bytes.substr(kName.size()));
    ReadContent content;
    if (!take(taker, bytes.size(), tile, content)) return refuse("is cut off or damaged");
    if (content.header.tile != markOfTile(tile))
        return refuse("belongs to other elevation data, or to another spacing");
    if (content.header.source != source) return refuse("was made for other roads");
    if (!isSoundFor(content, tile)) return refuse("holds values that no edit leaves");
    restorePoints(tile, content.points);
    forEachChunk(content.chunks, content.header.chunks,
                 [&](const ChunkState& chunk) { restoreChunk(tile, chunk); });
    tile.regions.setSpheres(content.spheres);
    tile.hidingGround.lowestM = std::min(tile.hidingGround.lowestM, content.header.lowestM);
    tile.addToMark(bytes);
    return foundation::success();
}

} // namespace osgTerrainROAM::core
