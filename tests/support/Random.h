// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace testsupport
{

/// A small seeded generator, the same on every machine (SplitMix64).
class Random
{
public:
    explicit Random(std::uint64_t seed) : _state(seed) {}

    std::uint64_t next()
    {
        std::uint64_t z = (_state += 0x9e3779b97f4a7c15ull);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        return z ^ (z >> 31);
    }

    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(next() % n); }
    double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

private:
    std::uint64_t _state;
};

} // namespace testsupport
