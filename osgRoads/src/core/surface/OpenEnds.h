// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osgRoads/core/place/PlacedNetwork.h>

namespace osgRoads::core
{

/// Tells where the surface of a road wears off into the ground: within kWearM of an end that leads nowhere.
/// An end leads on where the file links it, and where another road or the road's other end lies there. Beside
/// a bridge or tunnel, which have no ground, it stays whole.
class OpenEnds
{
public:
    static constexpr double kWearM = 15.0;

    OpenEnds(const PlacedNetwork& network, int road);

    /// Where the wear begins or ends, ascending.
    std::vector<double> cuts() const;
    /// 0: whole; 1 at an open end. Linear between cuts.
    double wearAt(double s) const;

private:
    double _length;
    bool _isStartOpen, _isEndOpen;
};

} // namespace osgRoads::core
