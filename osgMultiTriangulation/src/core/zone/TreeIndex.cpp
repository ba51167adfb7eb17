// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <iterator>

#include <boost/geometry/algorithms/intersects.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <osgMultiTriangulation/core/zone/TreeIndex.h>

namespace osgMultiTriangulation::core
{

namespace
{

using Place = boost::geometry::model::d2::point_xy<double>;
using Box = boost::geometry::model::box<Place>;
using Entry = std::pair<Box, std::uint32_t>;

} // namespace

struct TreeIndex::Boxes
{
    boost::geometry::index::rtree<Entry, boost::geometry::index::rstar<16>> tree;
};

TreeIndex::TreeIndex(std::span<const MtEntry> trees)
{
    std::vector<Entry> entries;
    for (std::uint32_t t = 0; t < trees.size(); ++t)
        entries.emplace_back(
            Box(Place(trees[t].low[0], trees[t].low[1]), Place(trees[t].high[0], trees[t].high[1])), t);
    _boxes = std::make_shared<const Boxes>(Boxes{decltype(Boxes::tree)(entries)});
}

std::vector<std::uint32_t> TreeIndex::near(double x, double y, double halfWidth, double halfHeight) const
{
    const Box square(Place(x - halfWidth, y - halfHeight), Place(x + halfWidth, y + halfHeight));
    std::vector<Entry> found;
    _boxes->tree.query(boost::geometry::index::intersects(square), std::back_inserter(found));
    std::vector<std::uint32_t> numbers;
    for (const Entry& entry : found)
        numbers.push_back(entry.second);
    std::ranges::sort(numbers);
    return numbers;
}

double distanceTo(const MtEntry& tree, double x, double y, double stepX, double stepY)
{
    const double beyondX = std::max({tree.low[0] - x, x - tree.high[0], 0.0});
    const double beyondY = std::max({tree.low[1] - y, y - tree.high[1], 0.0});
    return std::hypot(beyondX * stepX, beyondY * stepY);
}

} // namespace osgMultiTriangulation::core
