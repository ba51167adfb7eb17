// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace osgPMObjects::core
{

/// The priority of a collapse. Harmless ones come first, whatever their cost.
struct Urgency
{
    bool doesHarm = false; ///< it turns a face over: only when no other is left
    double cost = 0.0;

    auto operator<=>(const Urgency&) const = default;
};

/// A priority queue of positions by the urgency of their best collapse, least first; ties by number. A binary
/// heap with positions indexed, so that urgencies can change. Memory: 28 B a queued position, 4 B a possible
/// one. Cost: log n a change.
class CollapseQueue
{
public:
    explicit CollapseQueue(std::size_t positionCount) : _at(positionCount, kNone) {}

    bool isEmpty() const { return _heap.empty(); }
    std::uint32_t first() const { return _heap.front().second; }
    const Urgency& leastUrgency() const { return _heap.front().first; }

    /// Inserts a position, or changes its urgency.
    void set(std::uint32_t position, const Urgency& urgency)
    {
        if (_at[position] == kNone)
        {
            _at[position] = static_cast<std::uint32_t>(_heap.size());
            _heap.emplace_back(urgency, position);
        }
        else
            _heap[_at[position]].first = urgency;
        sink(rise(_at[position]));
    }

    void erase(std::uint32_t position)
    {
        const std::uint32_t hole = _at[position];
        if (hole == kNone) return;
        _at[position] = kNone;
        const Entry last = _heap.back();
        _heap.pop_back();
        if (hole == _heap.size()) return;
        place(hole, last);
        sink(rise(hole));
    }

private:
    static constexpr std::uint32_t kNone = ~0u;
    using Entry = std::pair<Urgency, std::uint32_t>;

    void place(std::uint32_t at, const Entry& entry)
    {
        _heap[at] = entry;
        _at[entry.second] = at;
    }

    std::uint32_t rise(std::uint32_t at)
    {
        const Entry entry = _heap[at];
        for (; at > 0 && entry < _heap[(at - 1) / 2]; at = (at - 1) / 2)
            place(at, _heap[(at - 1) / 2]);
        place(at, entry);
        return at;
    }

    void sink(std::uint32_t at)
    {
        const Entry entry = _heap[at];
        for (std::size_t child = 2u * at + 1; child < _heap.size(); child = 2u * at + 1)
        {
            if (child + 1 < _heap.size() && _heap[child + 1] < _heap[child]) ++child;
            if (entry < _heap[child]) break;
            place(at, _heap[child]);
            at = static_cast<std::uint32_t>(child);
        }
        place(at, entry);
    }

    std::vector<Entry> _heap;
    std::vector<std::uint32_t> _at; ///< by position: index in _heap
};

} // namespace osgPMObjects::core
