// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

#include <osgTerrainROAM/core/heightfield/GridRect.h>
#include <osgTerrainROAM/core/heightfield/SampleTable.h>

namespace osgTerrainROAM::core
{

/// The samples that edits have added between those of the raster, or instead of some: sparse, in square
/// chunks found by grid coordinates. Heights and bounds are kept exactly, 12 B a sample. A point without a
/// sample can have the bounds of its vertex.
/// Units: grid points; metres.
class FineSamples
{
public:
    static constexpr int kChunkShift = 4, kChunkSide = 1 << kChunkShift;
    using Sample = SampleTable::Sample;

    FineSamples() = default;
    FineSamples(FineSamples&&) noexcept = default;
    FineSamples& operator=(FineSamples&&) noexcept = default;

    bool isEmpty() const { return _chunks.empty(); }

    /// The number of samples that the present chunks have room for.
    std::size_t sampleSpace() const { return _chunks.size() * kChunkSide * kChunkSide; }

    /// Marks instead of a height: the point lies on the surface between the samples and counts among them
    /// where errors are measured (kOnSurface), or does not count (kNoHeight).
    static constexpr float kOnSurface = std::numeric_limits<float>::infinity();
    static constexpr float kNoHeight = std::numeric_limits<float>::quiet_NaN();
    static bool hasHeight(const Sample& sample) { return std::isfinite(sample.heightM); }

    /// Finds what is kept at a point: a sample, a point that counts among the samples, or only a vertex's
    /// bounds. Null: nothing.
    const Sample* find(int column, int row) const
    {
        const auto found = _chunks.find(keyOf(column, row));
        if (found == _chunks.end()) return nullptr;
        const Sample& sample = (*found->second)[slotOf(column, row)];
        return counts(sample) || sample.errorM > 0.0f ? &sample : nullptr;
    }

    /// Keeps a sample, or bounds.
    void set(int column, int row, const Sample& sample)
    {
        std::unique_ptr<Chunk>& chunk = _chunks[keyOf(column, row)];
        if (!chunk)
        {
            chunk = std::make_unique<Chunk>();
            chunk->fill(kNothing);
        }
        (*chunk)[slotOf(column, row)] = sample;
    }

    /// Removes what is kept at a point.
    void erase(int column, int row)
    {
        if (const auto found = _chunks.find(keyOf(column, row)); found != _chunks.end())
            (*found->second)[slotOf(column, row)] = kNothing;
    }

    /// Calls visit(column, row) for the points within a rectangle that count as samples. Their order depends
    /// on the content alone.
    template<class Visit>
    void forEachIn(const GridRect& rect, const Visit& visit) const
    {
        const std::int64_t west = rect.west >> kChunkShift, east = rect.east >> kChunkShift;
        const std::int64_t south = rect.south >> kChunkShift, north = rect.north >> kChunkShift;
        const bool fewKept =
            static_cast<std::int64_t>(_chunks.size()) < (east - west + 1) * (north - south + 1);
        if (fewKept)
        {
            for (const auto& [key, chunk] : _chunks)
                visitChunk(key, *chunk, rect, visit);
            return;
        }
        for (std::int64_t row = south; row <= north; ++row)
            for (std::int64_t column = west; column <= east; ++column)
                if (const auto found = _chunks.find(keyOfChunk(column, row)); found != _chunks.end())
                    visitChunk(found->first, *found->second, rect, visit);
    }

    /// The columns and rows of the south-western points of all chunks, by rows.
    std::vector<std::pair<int, int>> chunkPlaces() const
    {
        std::vector<Key> keys;
        for (const auto& [key, chunk] : _chunks)
            keys.push_back(key);
        std::sort(keys.begin(), keys.end());
        std::vector<std::pair<int, int>> places;
        for (const Key key : keys)
            places.push_back({static_cast<int>(key & 0xffffffffu) << kChunkShift, static_cast<int>(key >> 32)
                                                                                      << kChunkShift});
        return places;
    }

    using Chunk = std::array<Sample, kChunkSide * kChunkSide>;

    /// Replaces the chunk with this south-western point.
    void setChunk(int column, int row, const Chunk& samples)
    {
        _chunks[keyOf(column, row)] = std::make_unique<Chunk>(samples);
    }

    std::size_t memoryBytes() const { return _chunks.size() * (sizeof(Chunk) + 64); }

private:
    using Key = std::uint64_t;

    static constexpr Sample kNothing{kNoHeight, 0.0f, 0.0f};
    static bool counts(const Sample& sample) { return !std::isnan(sample.heightM); }

    static Key keyOfChunk(std::int64_t column, std::int64_t row)
    {
        return static_cast<Key>(row) << 32 | static_cast<Key>(column);
    }
    static Key keyOf(int column, int row) { return keyOfChunk(column >> kChunkShift, row >> kChunkShift); }
    static std::size_t slotOf(int column, int row)
    {
        return static_cast<std::size_t>((row & (kChunkSide - 1)) << kChunkShift |
                                        (column & (kChunkSide - 1)));
    }

    template<class Visit>
    static void visitChunk(Key key, const Chunk& chunk, const GridRect& rect, const Visit& visit)
    {
        const int west = static_cast<int>(key & 0xffffffffu) << kChunkShift;
        const int south = static_cast<int>(key >> 32) << kChunkShift;
        const GridRect here =
            GridRect{west, south, west + kChunkSide - 1, south + kChunkSide - 1}.cutTo(rect);
        for (int row = here.south; row <= here.north; ++row)
            for (int column = here.west; column <= here.east; ++column)
                if (counts(chunk[slotOf(column, row)])) visit(column, row);
    }

    std::unordered_map<Key, std::unique_ptr<Chunk>> _chunks;
};

} // namespace osgTerrainROAM::core
