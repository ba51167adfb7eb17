// SPDX-License-Identifier: Apache-2.0
#include "RoadChains.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace osgTerrainROAM::core
{

namespace
{

constexpr double kSameM = 0.05;

using EndKey = std::pair<std::int64_t, std::int64_t>;

/// Ends in the same square of 5 cm count as one. Close ends in different squares stay separate, which costs a
/// gap in a marking.
EndKey keyOf(const glm::dvec2& place)
{
    return {std::llround(place.x / kSameM), std::llround(place.y / kSameM)};
}

class Joiner
{
public:
    explicit Joiner(std::vector<Chain> pieces) : _pieces(std::move(pieces)), _used(_pieces.size(), false)
    {
        for (std::size_t i = 0; i < _pieces.size(); ++i)
            for (const glm::dvec2& end : {_pieces[i].points.front(), _pieces[i].points.back()})
                _ends[keyOf(end)].push_back(i);
    }

    std::vector<Chain> joined()
    {
        std::vector<Chain> chains;
        for (std::size_t i = 0; i < _pieces.size(); ++i)
        {
            if (_used[i]) continue;
            _used[i] = true;
            Chain chain = _pieces[i];
            extend(chain);
            std::reverse(chain.points.begin(), chain.points.end());
            extend(chain);
            std::reverse(chain.points.begin(), chain.points.end());
            chains.push_back(std::move(chain));
        }
        return chains;
    }

private:
    /// Appends the line that continues at the chain's last point.
    void extend(Chain& chain)
    {
        while (true)
        {
            const auto& meeting = _ends[keyOf(chain.points.back())];
            if (meeting.size() != 2) return;
            const std::size_t next = _used[meeting[0]] ? meeting[1] : meeting[0];
            if (_used[next] || !(_pieces[next].style == chain.style)) return;
            _used[next] = true;
            std::vector<glm::dvec2> more = _pieces[next].points;
            if (keyOf(more.front()) != keyOf(chain.points.back())) std::reverse(more.begin(), more.end());
            chain.points.insert(chain.points.end(), more.begin() + 1, more.end());
        }
    }

    std::vector<Chain> _pieces;
    std::vector<bool> _used;
    std::map<EndKey, std::vector<std::size_t>> _ends;
};

} // namespace

std::vector<Chain> joinedLines(const std::vector<GroundFeature>& features)
{
    std::vector<Chain> pieces;
    for (const GroundFeature& feature : features)
        if (!feature.isArea)
            for (const auto& path : feature.paths)
                pieces.push_back({feature.style, path});
    return Joiner(std::move(pieces)).joined();
}

} // namespace osgTerrainROAM::core
