// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include <glm/vec2.hpp>

namespace scenery
{

/// The room of an object: no other room may reach into its core.
struct Disc
{
    glm::dvec2 centre{0.0};
    double roomM = 0.0, coreM = 0.0; ///< core ≤ room; the same for what may not be touched at all
};

/// Returns the least distance of two objects: neither room reaches into the core of the other.
double leastDistanceM(const Disc& a, const Disc& b);

/// The discs taken so far, in a grid of cells. Cost of both functions: some discs of the neighbourhood.
class TakenDiscs
{
public:
    bool isFree(const Disc& disc) const;
    void take(const Disc& disc);

private:
    static constexpr double kCellM = 24.0;
    static std::int64_t cellOf(double metres);
    static std::uint64_t keyOf(std::int64_t column, std::int64_t row);

    std::unordered_map<std::uint64_t, std::vector<Disc>> _cells;
    double _mostRoomM = 0.0;
};

} // namespace scenery
