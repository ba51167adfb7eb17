// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <iterator>

#include <foundation/Random.h>

namespace scenery::models
{

/// A generator of seeded random numbers, the same on every machine; its state is one word.
class Dice
{
public:
    explicit Dice(std::uint64_t seed) : _bits(seed * foundation::SplitMix64::kStep + 0x632be59bd9b4e019ULL) {}

    /// Returns a number in [0, 1).
    double unit() { return static_cast<double>(_bits() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * unit(); }
    int below(int n) { return static_cast<int>(unit() * n); }
    bool chance(double share) { return unit() < share; }

    template<class Choices>
    auto oneOf(const Choices& choices)
    {
        return choices[static_cast<std::size_t>(below(static_cast<int>(std::size(choices))))];
    }

private:
    foundation::SplitMix64 _bits;
};

} // namespace scenery::models
