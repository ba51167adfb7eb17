// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgRoads/core/geometry/CubicBounds.h>

namespace osgRoads::core
{

namespace
{

void includePiece(const Cubic& piece, double from, double to, ValueRange& range)
{
    const double third = (to - from) / 3.0;
    const double start = piece.value(from), end = piece.value(to);
    range.include(start);
    range.include(start + third * piece.slope(from));
    range.include(end - third * piece.slope(to));
    range.include(end);
}

} // namespace

ValueRange boundsOf(const CubicProfile& profile, double from, double to)
{
    const std::vector<Cubic>& pieces = profile.pieces();
    const double first = profile.value(from);
    ValueRange range{first, first};
    const int begin = std::max(lastStartingBy(pieces, from), 0);
    for (auto i = static_cast<std::size_t>(begin); i < pieces.size() && pieces[i].s <= to; ++i)
    {
        const double end = i + 1 < pieces.size() ? std::min(pieces[i + 1].s, to) : to;

        includePiece(pieces[i], std::max(pieces[i].s, from), end, range);
    }
    return range;
}

} // namespace osgRoads::core
