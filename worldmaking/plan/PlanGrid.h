// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <glm/glm.hpp>

namespace worldmaking
{

/// A rectangle of the plane. Units: metres.
struct MapBox
{
    glm::dvec2 low{0.0}, high{0.0};

    bool meets(const MapBox& other) const
    {
        return low.x <= other.high.x && low.y <= other.high.y && high.x >= other.low.x &&
               high.y >= other.low.y;
    }
};

inline MapBox boxOf(const std::vector<glm::dvec2>& points)
{
    MapBox box{points.front(), points.front()};
    for (const glm::dvec2& point : points)
        box = {glm::min(box.low, point), glm::max(box.high, point)};
    return box;
}

/// Things with boxes, found by the squares that they touch.
class PlanGrid
{
public:
    void add(std::size_t thing, const MapBox& box)
    {
        forSquares(box, [&](std::uint64_t square) { _squares[square].push_back({thing, box}); });
    }

    /// Calls `use(thing)` for the things whose box meets a box, each once, in the order of their numbers.
    template<class Use>
    void near(const MapBox& box, const Use& use) const
    {
        std::vector<std::size_t> found;
        forSquares(box,
                   [&](std::uint64_t square)
                   {
                       const auto things = _squares.find(square);
                       if (things == _squares.end()) return;
                       for (const auto& [thing, its] : things->second)
                           if (its.meets(box)) found.push_back(thing);
                   });
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        for (const std::size_t thing : found)
            use(thing);
    }

private:
    static constexpr double kSideM = 100.0;

    template<class Use>
    static void forSquares(const MapBox& box, const Use& use)
    {
        const auto at = [](double metres) { return static_cast<std::int64_t>(std::floor(metres / kSideM)); };
        for (std::int64_t y = at(box.low.y); y <= at(box.high.y); ++y)
            for (std::int64_t x = at(box.low.x); x <= at(box.high.x); ++x)
                use((static_cast<std::uint64_t>(y) << 32) ^ static_cast<std::uint32_t>(x));
    }

    struct Boxed
    {
        std::size_t thing;
        MapBox box;
    };
    std::unordered_map<std::uint64_t, std::vector<Boxed>> _squares;
};

} // namespace worldmaking
