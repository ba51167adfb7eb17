// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace osgRoads::core
{

/// A cubic polynomial a + b·ds + c·ds² + d·ds³ of the distance ds from its start.
struct Cubic
{
    double s = 0.0; ///< where it starts, metres along the road (or from the start of its lane section)
    double a = 0.0, b = 0.0, c = 0.0, d = 0.0;

    double value(double at) const
    {
        const double ds = at - s;
        return a + ds * (b + ds * (c + ds * d));
    }
    double slope(double at) const
    {
        const double ds = at - s;
        return b + ds * (2.0 * c + ds * 3.0 * d);
    }
};

/// A function of s in pieces: each cubic holds from its start to the start of the next one. Before the first
/// piece, and without pieces, the value is 0.
/// Source: ASAM OpenDRIVE 1.8, 10.5.1 (elevation), 11.6 (lane width), 11.4 (lane offset).
class CubicProfile
{
public:
    CubicProfile() = default;

    /// `pieces`: ascending by s; of pieces with the same s the last one counts.
    explicit CubicProfile(std::vector<Cubic> pieces) : _pieces(std::move(pieces)) {}

    double value(double s) const
    {
        const Cubic* piece = pieceAt(s);
        return piece ? piece->value(s) : 0.0;
    }
    double slope(double s) const
    {
        const Cubic* piece = pieceAt(s);
        return piece ? piece->slope(s) : 0.0;
    }
    bool isEmpty() const { return _pieces.empty(); }
    const std::vector<Cubic>& pieces() const { return _pieces; }

    /// Returns the piece that holds at s, or nullptr before the first.
    const Cubic* pieceAt(double s) const;

private:
    std::vector<Cubic> _pieces;
};

/// Returns the index of the last element whose member `s` is at most `at`, or -1. `elements`: ascending by s.
template<class Elements>
int lastStartingBy(const Elements& elements, double at)
{
    int low = 0, high = static_cast<int>(elements.size());
    while (low < high)
    {
        const int middle = low + (high - low) / 2;
        if (elements[static_cast<std::size_t>(middle)].s <= at)
            low = middle + 1;
        else
            high = middle;
    }
    return low - 1;
}

inline const Cubic* CubicProfile::pieceAt(double s) const
{
    const int index = lastStartingBy(_pieces, s);
    return index < 0 ? nullptr : &_pieces[static_cast<std::size_t>(index)];
}

} // namespace osgRoads::core
