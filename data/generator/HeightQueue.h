// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace islandgen
{

/// A monotone priority queue of cells: no key falls below the last one taken, as in a flood.
/// Buckets of equal height range become heaps only when the flood reaches them, so the heaps stay small and
/// in cache. Equal heights leave in the order of their cell numbers.
/// Invariant: no waiting entry is lower than the last taken.
/// Cost: O(log of a bucket's size) per entry.
class HeightQueue
{
public:
    struct Entry
    {
        float heightM;
        std::int32_t cell;
    };

    HeightQueue(float lowestM, float highestM, int buckets)
        : _lowestM(lowestM),
          _perMetre(static_cast<float>(buckets - 1) / std::max(highestM - lowestM, 1e-3f)),
          _buckets(static_cast<std::size_t>(buckets))
    {
    }

    void push(Entry entry)
    {
        const auto bucket = bucketOf(entry.heightM);
        _buckets[bucket].push_back(entry);
        if (bucket == _current) std::push_heap(_buckets[bucket].begin(), _buckets[bucket].end(), later);
    }

    /// Takes the lowest entry; false when none is left.
    bool pop(Entry& entry)
    {
        while (_buckets[_current].empty())
        {
            if (_current + 1 == _buckets.size()) return false;
            std::vector<Entry>().swap(_buckets[_current]);
            ++_current;
            std::make_heap(_buckets[_current].begin(), _buckets[_current].end(), later);
        }
        std::vector<Entry>& heap = _buckets[_current];
        std::pop_heap(heap.begin(), heap.end(), later);
        entry = heap.back();
        heap.pop_back();
        return true;
    }

private:
    static bool later(const Entry& a, const Entry& b)
    {
        return a.heightM != b.heightM ? a.heightM > b.heightM : a.cell > b.cell;
    }

    std::size_t bucketOf(float heightM) const
    {
        const float position = std::max((heightM - _lowestM) * _perMetre, 0.0f);
        const auto last = _buckets.size() - 1;
        const auto bucket = position >= static_cast<float>(last) ? last : static_cast<std::size_t>(position);
        return std::max(bucket, _current);
    }

    float _lowestM;
    float _perMetre;
    std::size_t _current = 0;
    std::vector<std::vector<Entry>> _buckets;
};

} // namespace islandgen
