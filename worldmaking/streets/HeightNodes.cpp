// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/HeightNodes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "worldmaking/streets/SharedPaving.h"

namespace worldmaking
{

namespace
{

constexpr double kShortRoadM = 12.0; ///< shorter ones lie in the plane of their crossings
constexpr double kMostAreaM = 60.0;  ///< across: larger planes leave the ground

HeightRow rowOf(const StreetGraph& graph, const StreetChain& chain, const CentreLine& line,
                const ChainCut& cut)
{
    HeightRow row;
    const double lengthM = line.lengthM() - cut.startM - cut.endM;
    const int cells =
        std::max(HeightRow::kLeastCells, static_cast<int>(std::ceil(lengthM / HeightRow::kStepM)));
    row.stepM = lengthM / cells;
    std::size_t piece = 0;
    for (int k = 0; k <= cells; ++k)
    {
        const double alongM = cut.startM + k * row.stepM;
        while (piece + 1 < chain.pieces.size() && line.pointsM()[piece + 1] <= alongM)
            ++piece;
        const StreetTraits& traits = graph.traitsAt(chain, piece);
        row.points.push_back(line.at(alongM));
        row.steepest.push_back(traits.steepest);
        row.isFree.push_back(traits.place != StreetPlace::ground);
        row.isTunnel.push_back(traits.place == StreetPlace::tunnel);
    }
    return row;
}

/// Holds as many nodes in the planes of the crossings as lie beside other arms, and one more: the curve
/// between two nodes follows those around them, too. Some in the middle stay free.
void holdShared(HeightRow& row, const ChainCut& shared)
{
    const auto heldFor = [&](double sharedM)
    { return 1 + static_cast<std::size_t>(std::ceil(sharedM / row.stepM)); };
    row.heldStart = heldFor(shared.startM), row.heldEnd = heldFor(shared.endM);
    const std::size_t most = std::max<std::size_t>(2, row.last() > 3 ? row.last() - 3 : 0);
    while (row.heldStart + row.heldEnd > most)
        --(row.heldStart >= row.heldEnd ? row.heldStart : row.heldEnd);
}

/// Crossings that become one area, each with the box of its mouths.
class AreaFinder
{
public:
    AreaFinder(const StreetGraph& graph, const HeightNodes& nodes) : _parents(graph.crossings.size())
    {
        std::iota(_parents.begin(), _parents.end(), 0);
        for (const Crossing& crossing : graph.crossings)
        {
            Box box;
            for (const StreetArm& arm : crossing.arms)
                box.add(nodes.mouthPoint(arm).position);
            _boxes.push_back(box);
        }
    }

    int rootOf(int crossing) const
    {
        while (_parents[static_cast<std::size_t>(crossing)] != crossing)
            crossing = _parents[static_cast<std::size_t>(crossing)];
        return crossing;
    }

    /// Makes one area of two, unless it would be too large.
    void join(int a, int b)
    {
        const auto low = static_cast<std::size_t>(std::min(rootOf(a), rootOf(b)));
        const auto high = static_cast<std::size_t>(std::max(rootOf(a), rootOf(b)));
        Box box = _boxes[low];
        box.add(_boxes[high].low);
        box.add(_boxes[high].high);
        if (low == high || glm::distance(box.low, box.high) > kMostAreaM) return;
        _parents[high] = static_cast<int>(low);
        _boxes[low] = box;
    }

private:
    struct Box
    {
        glm::dvec2 low{1e300}, high{-1e300};

        void add(const glm::dvec2& point) { low = glm::min(low, point), high = glm::max(high, point); }
    };

    std::vector<int> _parents;
    std::vector<Box> _boxes;
};

/// Joins crossings over short roads, the shortest first.
AreaFinder joined(const StreetGraph& graph, const HeightNodes& nodes)
{
    AreaFinder finder(graph, nodes);
    std::vector<std::pair<double, std::size_t>> roads;
    for (std::size_t i = 0; i < graph.chains.size(); ++i)
        if (nodes.rows[i].lengthM() < kShortRoadM) roads.emplace_back(nodes.rows[i].lengthM(), i);
    std::sort(roads.begin(), roads.end());
    for (const auto& [lengthM, i] : roads)
    {
        const StreetChain& chain = graph.chains[i];
        if (chain.startCrossing >= 0 && chain.endCrossing >= 0)
            finder.join(chain.startCrossing, chain.endCrossing);
    }
    return finder;
}

void addAreas(const StreetGraph& graph, HeightNodes& nodes)
{
    const AreaFinder finder = joined(graph, nodes);
    for (std::size_t i = 0; i < graph.crossings.size(); ++i)
    {
        const auto root = static_cast<std::size_t>(finder.rootOf(static_cast<int>(i))); // at most i
        if (root == i) nodes.areas.emplace_back();
        nodes.areaOf.push_back(root == i ? static_cast<int>(nodes.areas.size()) - 1 : nodes.areaOf[root]);
        auto& arms = nodes.areas[static_cast<std::size_t>(nodes.areaOf[i])].arms;
        arms.insert(arms.end(), graph.crossings[i].arms.begin(), graph.crossings[i].arms.end());
    }
    for (CrossingArea& area : nodes.areas)
        for (const StreetArm& arm : area.arms)
        {
            area.middle += nodes.mouthPoint(arm).position / static_cast<double>(area.arms.size());
            area.isFree = area.isFree && nodes.rows[arm.chain].isFree[nodes.mouth(arm)] != 0;
        }
}

} // namespace

HeightNodes heightNodesOf(const StreetGraph& graph, const std::vector<CentreLine>& lines,
                          const std::vector<ChainCut>& cuts)
{
    HeightNodes nodes;
    for (std::size_t i = 0; i < graph.chains.size(); ++i)
        nodes.rows.push_back(rowOf(graph, graph.chains[i], lines[i], cuts[i]));
    const auto shared = sharedPaving(graph, lines, cuts);
    for (std::size_t i = 0; i < graph.chains.size(); ++i)
        holdShared(nodes.rows[i], shared[i]);
    addAreas(graph, nodes);
    nodes.count = nodes.areas.size();
    for (HeightRow& row : nodes.rows)
    {
        row.first = nodes.count;
        nodes.count += row.points.size();
    }
    return nodes;
}

} // namespace worldmaking
