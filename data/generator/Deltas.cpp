// SPDX-License-Identifier: Apache-2.0
#include <queue>

#include "Coast.h"

namespace islandgen
{

namespace
{

struct Reached
{
    float cost;
    std::int32_t cell;
    bool operator<(const Reached& other) const
    {
        return cost != other.cost ? cost > other.cost : cell > other.cell; // the cheapest is the queue's top
    }
};

/// Spreads one river's sediment from its mouth.
class DeltaBuilder
{
public:
    DeltaBuilder(Grid<std::uint8_t>& isSea, const Grid<float>& heightM, Noise noise)
        : _isSea(isSea), _heightM(heightM), _noise(noise), _visit(isSea.side, -1)
    {
    }

    void build(int mouth, float sedimentM)
    {
        std::priority_queue<Reached> queue;
        queue.push({0.0f, mouth});
        _visit[mouth] = mouth;
        while (!queue.empty() && sedimentM > 0.0f)
        {
            const Reached reached = queue.top();
            queue.pop();
            if (_isSea[reached.cell])
            {
                sedimentM -= kSurfaceM - _heightM[reached.cell];
                _isSea[reached.cell] = 0;
            }
            spread(queue, reached, mouth);
        }
    }

private:
    static constexpr float kSurfaceM = 1.0f;

    void spread(std::priority_queue<Reached>& queue, const Reached& reached, int mouth)
    {
        const int column = reached.cell % _isSea.side;
        const int row = reached.cell / _isSea.side;
        for (const NeighbourStep& step : kNeighbours)
        {
            const int c = column + step.column;
            const int r = row + step.row;
            if (_isSea.onEdge(std::clamp(c, 0, _isSea.side - 1), std::clamp(r, 0, _isSea.side - 1))) continue;
            const int cell = _isSea.index(c, r);
            if (_visit[cell] == mouth || _heightM[cell] > 0.0f) continue;
            _visit[cell] = mouth;
            const float u = static_cast<float>(c) / static_cast<float>(_isSea.side - 1) * 60.0f;
            const float v = static_cast<float>(r) / static_cast<float>(_isSea.side - 1) * 60.0f;
            const float drag = 1.0f + 0.6f * _noise.fractal(u, v, 3);
            queue.push({reached.cost + step.distance * std::max(drag, 0.2f), cell});
        }
    }

    Grid<std::uint8_t>& _isSea;
    const Grid<float>& _heightM;
    Noise _noise;
    Grid<std::int32_t> _visit; // the last mouth that came here
};

} // namespace

void buildDeltas(Grid<std::uint8_t>& isSea, const Grid<float>& heightM, const DrainageNetwork& network,
                 const Grid<float>& sedimentM, Noise noise)
{
    Grid<float> load = sedimentM;
    DeltaBuilder builder(isSea, heightM, noise);
    const Grid<std::uint8_t> wasSea = isSea;
    for (std::size_t i = network.downstreamFirst.size(); i-- > 0;)
    {
        const std::int32_t cell = network.downstreamFirst[i];
        if (wasSea[cell]) continue;
        const std::int32_t receiver = network.receiver[cell];
        if (wasSea[receiver])
            builder.build(receiver, load[cell]);
        else
            load[receiver] += load[cell];
    }
}

} // namespace islandgen
