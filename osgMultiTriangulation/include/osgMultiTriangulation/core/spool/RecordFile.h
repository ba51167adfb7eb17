// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

#include <foundation/Result.h>

namespace osgMultiTriangulation::core
{

/// An open file of bytes that are read and written at places. After a failure all further calls do nothing;
/// outcome() tells it.
/// Threads: any number may read and write at once, at different places.
class PlacedBytes
{
public:
    PlacedBytes() = default;
    ~PlacedBytes();
    PlacedBytes(PlacedBytes&& other) noexcept;
    PlacedBytes& operator=(PlacedBytes&& other) noexcept;

    /// Errors: no such file or folder, no permission. `create`: makes it, or empties it.
    static foundation::Result<PlacedBytes> open(const std::filesystem::path& file, bool create);

    void read(std::span<std::byte> bytes, std::uint64_t place) const;
    void write(std::span<const std::byte> bytes, std::uint64_t place) const;
    std::uint64_t size() const;
    foundation::Outcome outcome() const;

private:
    std::filesystem::path _file;
    int _descriptor = -1;
    std::unique_ptr<std::uint32_t> _failure; ///< an errno, set by any thread; 0: none
    void fail(int reason) const;
};

/// A file of plain records, in the order of the machine's bytes. Appended to by one thread; then read through
/// a RecordCache.
/// Memory: `kBuffered` records.
template<class T>
class RecordFile
{
    static_assert(std::is_trivially_copyable_v<T>);

public:
    static constexpr std::size_t kBuffered = 1024;

    RecordFile() = default;

    static foundation::Result<RecordFile> create(const std::filesystem::path& file)
    {
        return opened(file, true);
    }
    static foundation::Result<RecordFile> open(const std::filesystem::path& file)
    {
        return opened(file, false);
    }

    std::uint64_t size() const { return _count + _buffer.size(); }

    void append(const T& record)
    {
        _buffer.push_back(record);
        if (_buffer.size() == kBuffered) flush();
    }

    void flush()
    {
        write(_buffer, _count);
        _count += _buffer.size();
        _buffer.clear();
    }

    /// Reads records that have been flushed. What cannot be read is zero; outcome() tells.
    void read(std::span<T> records, std::uint64_t first) const
    {
        _bytes.read(std::as_writable_bytes(records), first * sizeof(T));
    }

    void write(std::span<const T> records, std::uint64_t first) const
    {
        if (!records.empty()) _bytes.write(std::as_bytes(records), first * sizeof(T));
    }

    /// Calls visit(records) for runs of records, in order. All have been flushed.
    template<class Visit>
    void scan(const Visit& visit) const
    {
        std::vector<T> run(kBuffered);
        for (std::uint64_t first = 0; first < _count; first += run.size())
        {
            run.resize(static_cast<std::size_t>(std::min<std::uint64_t>(kBuffered, _count - first)));
            read(run, first);
            visit(std::span<const T>(run));
        }
    }

    foundation::Outcome outcome() const { return _bytes.outcome(); }

private:
    static foundation::Result<RecordFile> opened(const std::filesystem::path& file, bool create)
    {
        auto bytes = PlacedBytes::open(file, create);
        if (!bytes) return bytes.error();
        RecordFile records;
        records._bytes = std::move(*bytes);
        records._count = records._bytes.size() / sizeof(T);
        return records;
    }

    PlacedBytes _bytes;
    std::uint64_t _count = 0; ///< records in the file
    std::vector<T> _buffer;
};

/// Some blocks of a record file in memory, for records that are asked for in no order.
/// Each block has one place in the cache. Changed blocks are written when they make room, and by flush().
/// Threads: one. Memory: `blocks` · 256 records.
template<class T>
class RecordCache
{
public:
    static constexpr std::size_t kBlock = 256;

    explicit RecordCache(const RecordFile<T>& file, std::size_t blocks = 64)
        : _file(file), _records(blocks * kBlock), _blocks(blocks, Block{kNoBlock, false})
    {
    }

    const T& at(std::uint64_t number) { return fetch(number).record; }

    void set(std::uint64_t number, const T& record)
    {
        const Found found = fetch(number);
        found.record = record;
        _blocks[found.block].isChanged = true;
    }

    void flush()
    {
        for (std::size_t b = 0; b < _blocks.size(); ++b)
            writeBack(b);
    }

private:
    static constexpr std::uint64_t kNoBlock = ~std::uint64_t{0};

    struct Block
    {
        std::uint64_t number;
        bool isChanged;
    };

    struct Found
    {
        T& record;
        std::size_t block;
    };

    Found fetch(std::uint64_t number)
    {
        const std::uint64_t block = number / kBlock;
        const auto place = static_cast<std::size_t>(block % _blocks.size());
        if (_blocks[place].number != block)
        {
            writeBack(place);
            _blocks[place].number = block;
            _file.read(own(place, block), block * kBlock);
        }
        return {_records[place * kBlock + number % kBlock], place};
    }

    std::span<T> own(std::size_t place, std::uint64_t block)
    {
        const std::uint64_t left = _file.size() - block * kBlock;
        return std::span(_records).subspan(place * kBlock,
                                           static_cast<std::size_t>(std::min<std::uint64_t>(kBlock, left)));
    }

    void writeBack(std::size_t place)
    {
        if (!_blocks[place].isChanged) return;
        _file.write(own(place, _blocks[place].number), _blocks[place].number * kBlock);
        _blocks[place].isChanged = false;
    }

    const RecordFile<T>& _file;
    std::vector<T> _records;
    std::vector<Block> _blocks;
};

} // namespace osgMultiTriangulation::core
