// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace osgPMObjects::core
{

/// Finds equal things among numbered ones: open addressing over their numbers. What a thing is, its hash and equality are
/// the caller's, given with each question; the index keeps numbers alone. Order of insertion decides which of several equal
/// things is found, so results do not depend on the hash.
/// Memory: 8 to 16 B a thing. Threads: one.
class HashIndex
{
public:
    static constexpr std::uint32_t kNone = ~0u;

    explicit HashIndex(std::size_t expected) : _slots(std::bit_ceil(2 * expected + 16), kNone) {}

    /// The number of an equal thing, or `candidate` itself, which is then in the index.
    /// `isEqual(number)` compares the candidate with the thing of that number; `hashOf(number)` is asked when it grows.
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

/// Stirs a word into a hash. Source: the finaliser of MurmurHash3 (Appleby, public domain), constants as there.
inline std::uint64_t stir(std::uint64_t hash, std::uint64_t word)
{
    hash = (hash ^ word) * 0xff51afd7ed558ccdULL;
    hash = (hash ^ (hash >> 33)) * 0xc4ceb9fe1a85ec53ULL;
    return hash ^ (hash >> 33);
}

/// The bits of a number for hashing; +0 and -0, which compare equal, alike.
inline std::uint64_t bitsOf(double value)
{
    return std::bit_cast<std::uint64_t>(value == 0.0 ? 0.0 : value);
}

} // namespace osgPMObjects::core
