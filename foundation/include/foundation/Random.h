// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

namespace foundation
{

/// Mixes the bits of a number, so that each bit of the answer depends on all: the finaliser of SplitMix64.
/// The same on every machine; 0 gives 0.
constexpr std::uint64_t mixedBits(std::uint64_t bits)
{
    bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebULL;
    return bits ^ (bits >> 31U);
}

/// A generator of seeded random bits, the same on every machine; its state is one word. It is a
/// std::uniform_random_bit_generator.
/// Source: Steele, Lea & Flood, *Fast splittable pseudorandom number generators* (2014), SplitMix64.
class SplitMix64
{
public:
    using result_type = std::uint64_t;
    static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15ULL; ///< 2^64 over the golden ratio

    explicit constexpr SplitMix64(std::uint64_t seed) : _state(seed) {}

    static constexpr std::uint64_t min() { return 0; }
    static constexpr std::uint64_t max() { return std::numeric_limits<std::uint64_t>::max(); }
    constexpr std::uint64_t operator()() { return mixedBits(_state += kStep); }

private:
    std::uint64_t _state;
};

} // namespace foundation
