// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <iterator>

namespace scenery::models
{

/// A generator of seeded random numbers, the same on every machine; its state is one word.
/// Source: SplitMix64 of Steele, Lea & Flood, *Fast Splittable Pseudorandom Number Generators*, 2014.
class Dice
{
public:
    explicit Dice(std::uint64_t seed) : _state(seed * 0x9e3779b97f4a7c15ULL + 0x632be59bd9b4e019ULL) {}

    /// Returns a number in [0, 1).
    double unit()
    {
        std::uint64_t z = (_state += 0x9e3779b97f4a7c15ULL);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
    }
    double between(double low, double high) { return low + (high - low) * unit(); }
    int below(int n) { return static_cast<int>(unit() * n); }
    bool chance(double share) { return unit() < share; }

    template<class Choices>
    auto oneOf(const Choices& choices)
    {
        return choices[static_cast<std::size_t>(below(static_cast<int>(std::size(choices))))];
    }

private:
    std::uint64_t _state;
};

} // namespace scenery::models
