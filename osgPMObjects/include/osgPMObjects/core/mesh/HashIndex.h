// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace osgPMObjects::core
{

/// A hash table of numbered elements, with open addressing. It stores numbers only: the caller gives hash and
/// equality with each look-up. Order of insertion decides which of several equal elements is found, so
/// results do not depend on the hash.
/// Memory: 8 to 16 B an element. Threads: one.
class HashIndex
{
public:
    static constexpr std::uint32_t kNone = ~0u;

    explicit HashIndex(std::size_t expected) : _slots(std::bit_ceil(2 * expected + 16), kNone) {}

    /// Returns the number of an equal element, or adds `candidate` and returns it.
    /// `isEqual(number)` compares the candidate with an element; `hashOf(number)` is called when the table
    /// grows.
    template<class Equal, class Hash>
    std::uint32_t findOrAdd(std::uint32_t candidate, std::uint64_t hash, const Equal& isEqual,
                            const Hash& hashOf)
    {
        if (2 * (_size + 1) > _slots.size()) grow(hashOf);
        std::size_t slot = slotOf(hash);
        for (; _slots[slot] != kNone; slot = (slot + 1) & (_slots.size() - 1))
            if (isEqual(_slots[slot])) return _slots[slot];
        _slots[slot] = candidate;
        ++_size;
        return candidate;
    }

    std::size_t size() const { return _size; }

private:
    std::size_t slotOf(std::uint64_t hash) const { return hash & (_slots.size() - 1); }

    template<class Hash>
    void grow(const Hash& hashOf)
    {
        std::vector<std::uint32_t> old(2 * _slots.size(), kNone);
        old.swap(_slots);
        for (const std::uint32_t number : old)
        {
            if (number == kNone) continue;
            std::size_t slot = slotOf(hashOf(number));
            while (_slots[slot] != kNone)
                slot = (slot + 1) & (_slots.size() - 1);
            _slots[slot] = number;
        }
    }

    std::vector<std::uint32_t> _slots;
    std::size_t _size = 0;
};

/// Mixes a word into a hash. Source: Appleby, *MurmurHash3* (2011, public domain), finaliser fmix64 and its
/// constants.
inline std::uint64_t stir(std::uint64_t hash, std::uint64_t word)
{
    hash = (hash ^ word) * 0xff51afd7ed558ccdULL;
    hash = (hash ^ (hash >> 33)) * 0xc4ceb9fe1a85ec53ULL;
    return hash ^ (hash >> 33);
}

/// Returns the bits of a number for hashing; the same for +0 and -0, which compare equal.
inline std::uint64_t bitsOf(double value)
{
    return std::bit_cast<std::uint64_t>(value == 0.0 ? 0.0 : value);
}

} // namespace osgPMObjects::core
