// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <thread>
#include <utility>

#include <foundation/Threads.h>

#include <osgTerrainROAM/core/edit/HeightRule.h>
#include <osgTerrainROAM/core/heightfield/GroundQuery.h>

namespace osgTerrainROAM::core
{

namespace
{

constexpr double kLeastChangeM = 1e-4;
constexpr int kBlockShift = 3;           ///< log2 of the points, or samples, along a block
constexpr std::size_t kLeastBlocks = 64; ///< for a thread
constexpr double kSmallBoxM =
    250.0; ///< within one the ground's height moves places by less than a grid point

/// The grid coordinates of a place. `isExact`: found on the ground there; else by TileFrame::gridNear(), off
/// by up to a sample.
glm::dvec2 gridOf(const PlacedTile& tile, const glm::dvec2& place, bool& isExact)
{
    const auto ground = isExact ? groundAt(tile, place.x, place.y) : std::optional<GroundPoint>(std::nullopt);
    isExact = ground.has_value();
    return ground ? tile.frame().gridAt(ground->position) : tile.frame().gridNear(place);
}

/// The points of the data in a box, and perhaps a few around it: on the curved Earth grid lines are slightly
/// curved, and the ground's height shifts places, by less than a point within a small box.
GridRect placesIn(const PlacedTile& tile, const PlanBox& box)
{
    glm::dvec2 low(1e30), high(-1e30);
    const bool isCurved = tile.frame().placement() == Placement::curved;
    const glm::dvec2 size = box.high - box.low;
    bool isExact = isCurved && std::max(size.x, size.y) <= kSmallBoxM;
    for (const double x : {box.low.x, box.high.x})
        for (const double y : {box.low.y, box.high.y})
        {
            const glm::dvec2 grid = gridOf(tile, {x, y}, isExact);
            low = glm::min(low, grid);
            high = glm::max(high, grid);
        }
    const int least = !isCurved ? 1 : (isExact ? 2 : 2 << tile.grid().exponent());
    const int slack =
        least + (isCurved ? static_cast<int>(0.01 * std::max(high.x - low.x, high.y - low.y)) : 0);
    const auto whole = [&](double v) { return static_cast<int>(std::clamp(v, -1e9, 1e9)); };
    return GridRect{whole(low.x), whole(low.y), whole(high.x) + 1, whole(high.y) + 1}.grownBy(slack).cutTo(
        {0, 0, tile.grid().dataColumns() - 1, tile.grid().dataRows() - 1});
}

/// The blocks of the grid that boxes touch, each once.
class Blocks
{
public:
    explicit Blocks(int shift) : _shift(shift) {}

    void add(const GridRect& rect)
    {
        if (rect.isEmpty()) return;
        for (int row = rect.south >> _shift; row <= rect.north >> _shift; ++row)
            for (int column = rect.west >> _shift; column <= rect.east >> _shift; ++column)
                _blocks.emplace(row, column);
    }

    /// The grid points of each block, in the order of rows.
    std::vector<GridRect> rects() const
    {
        std::vector<GridRect> rects;
        for (const auto& [row, column] : _blocks)
        {
            const int west = column << _shift, south = row << _shift, size = 1 << _shift;
            rects.push_back({west, south, west + size - 1, south + size - 1});
        }
        return rects;
    }

    std::size_t size() const { return _blocks.size(); }

private:
    int _shift;
    std::set<std::pair<int, int>> _blocks;
};

/// Adds what a rule changes at the points, or samples, of a block.
void addChanges(const GridRect& block, const HeightRule& rule, const PlacedTile& tile, bool ofSamples,
                std::vector<HeightChange>& changes)
{
    const auto look = [&](int column, int row)
    {
        const double heightM = tile.samples().heightM(column, row);
        const glm::dvec2 place = tile.frame().positionOf(column, row, heightM);
        const double wantedM = rule(place, heightM);
        if (std::abs(wantedM - heightM) > kLeastChangeM)
            changes.push_back({{column, row}, static_cast<float>(wantedM)});
    };
    if (ofSamples) return tile.samples().forEachSample(block, look);
    for (int row = block.south; row <= block.north; ++row)
        for (int column = block.west; column <= block.east; ++column)
            if (tile.samples().isGround(column, row)) look(column, row);
}

/// The changes in all blocks, in their order. Each thread looks at a run of blocks.
std::vector<HeightChange> changesIn(const std::vector<GridRect>& blocks, const HeightRule& rule,
                                    const PlacedTile& tile, bool ofSamples)
{
    const GridRect data{0, 0, tile.grid().dataColumns() - 1, tile.grid().dataRows() - 1};
    const std::size_t most = std::clamp<std::size_t>(foundation::processors(), 1, 8);
    const std::size_t runs = std::clamp(blocks.size() / kLeastBlocks, std::size_t{1}, most);
    std::vector<std::vector<HeightChange>> found(runs);
    const auto look = [&](std::size_t run)
    {
        for (std::size_t i = blocks.size() * run / runs; i < blocks.size() * (run + 1) / runs; ++i)
            addChanges(blocks[i].cutTo(data), rule, tile, ofSamples, found[run]);
    };
    foundation::Threads threads;
    for (std::size_t run = 1; run < runs; ++run)
        threads.run([&look, run] { look(run); });
    look(0);
    threads.join();
    std::vector<HeightChange> changes = std::move(found.front());
    for (std::size_t run = 1; run < runs; ++run)
        changes.insert(changes.end(), found[run].begin(), found[run].end());
    return changes;
}

} // namespace

foundation::Result<std::vector<HeightChange>> changesBy(const HeightRule& rule, const PlacedTile& tile,
                                                        std::span<const PlanBox> boxes, EditDetail detail)
{
    const bool ofSamples = detail == EditDetail::samples;
    Blocks blocks(kBlockShift + (ofSamples ? tile.grid().exponent() : 0));
    for (const PlanBox& box : boxes)
        blocks.add(placesIn(tile, box));
    const auto refuse = [&](const char* what, const char* remedy) {
        return foundation::Error{tile.field().name, what, remedy};
    };
    if (blocks.size() == 0) return refuse("the edit lies beyond the data", "give places in the tile's frame");
    if (blocks.size() > kMostEditedPlaces >> (2 * kBlockShift))
        return refuse("the edit is too large for so fine a grid", "edit samples only, or in parts");

    return changesIn(blocks.rects(), rule, tile, ofSamples);
}

} // namespace osgTerrainROAM::core
