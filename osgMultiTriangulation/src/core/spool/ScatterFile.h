// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include <osgMultiTriangulation/core/spool/RecordFile.h>

namespace osgMultiTriangulation::core
{

/// Records dealt out to groups in one file, in the order they come. How many each group gets is known before.
/// Threads: added to by one; then any number may read. Memory: `kWaiting` records a group until flush().
template<class T>
class ScatterFile
{
public:
    static constexpr std::size_t kWaiting = 64;

    ScatterFile() = default;

    /// `counts`: records by group.
    static foundation::Result<ScatterFile> create(const std::filesystem::path& file,
                                                  const std::vector<std::uint64_t>& counts)
    {
        return over(RecordFile<T>::create(file), counts);
    }

    /// Takes a file that has been flushed, to be read. Errors: it has another size.
    static foundation::Result<ScatterFile> open(const std::filesystem::path& file,
                                                const std::vector<std::uint64_t>& counts)
    {
        auto scatter = over(RecordFile<T>::open(file), counts);
        if (scatter && scatter->_records.size() != scatter->_firstOf.back())
            return foundation::Error{file.string(), "has another size than it was written with",
                                     "plan the build again"};
        return scatter;
    }

    void add(std::uint32_t group, const T& record)
    {
        _waiting[group].push_back(record);
        if (_waiting[group].size() == kWaiting) give(group);
    }

    void flush()
    {
        for (std::uint32_t group = 0; group < _waiting.size(); ++group)
            give(group);
        std::vector<std::vector<T>>().swap(_waiting);
    }

    std::vector<T> read(std::uint32_t group) const
    {
        std::vector<T> records(static_cast<std::size_t>(_firstOf[group + 1] - _firstOf[group]));
        if (!records.empty()) _records.read(records, _firstOf[group]);
        return records;
    }

    std::uint32_t groups() const { return static_cast<std::uint32_t>(_firstOf.size() - 1); }
    std::vector<std::uint64_t> counts() const
    {
        std::vector<std::uint64_t> counts;
        for (std::uint32_t group = 0; group < groups(); ++group)
            counts.push_back(_firstOf[group + 1] - _firstOf[group]);
        return counts;
    }
    foundation::Outcome outcome() const { return _records.outcome(); }

private:
    static foundation::Result<ScatterFile> over(foundation::Result<RecordFile<T>> records,
                                                const std::vector<std::uint64_t>& counts)
    {
        if (!records) return records.error();
        ScatterFile scatter;
        scatter._records = std::move(*records);
        scatter._firstOf.push_back(0);
        for (const std::uint64_t count : counts)
            scatter._firstOf.push_back(scatter._firstOf.back() + count);
        scatter._next.assign(scatter._firstOf.begin(), scatter._firstOf.end() - 1);
        scatter._waiting.resize(counts.size());
        return scatter;
    }

    void give(std::uint32_t group)
    {
        _records.write(_waiting[group], _next[group]);
        _next[group] += _waiting[group].size();
        _waiting[group].clear();
    }

    RecordFile<T> _records;
    std::vector<std::uint64_t> _firstOf; ///< by group, and one more
    std::vector<std::uint64_t> _next;    ///< by group: where it goes on
    std::vector<std::vector<T>> _waiting;
};

} // namespace osgMultiTriangulation::core
