// SPDX-License-Identifier: Apache-2.0
#include <cassert>
#include <map>

#include <osgTerrainROAM/core/roam/PatchShape.h>
#include <osgTerrainROAM/core/roam/SplitBounds.h>

namespace osgTerrainROAM::core
{

namespace
{

/// Bisects a leaf k times, in a grid whose origin is the apex and whose axes are the legs: the left one along
/// the columns.
class Bisection
{
public:
    explicit Bisection(PatchShape& shape) : _shape(shape)
    {
        _shape.segments = 1 << (_shape.exponent / 2);
        const int last = _shape.segments;
        visit({{0, 0}, {last, 0}, {0, last}}, _shape.exponent, false);
    }

private:
    /// `turned`: the other half comes first, so that the curve continues where it left the triangle before.
    void visit(const GridTriangle& t, int levels, bool turned)
    {
        if (levels == 0)
        {
            _shape.triangles.push_back({vertex(t.apex), vertex(t.left), vertex(t.right)});
            return;
        }
        const auto halves = t.children();
        visit(halves[turned ? 1 : 0], levels - 1, !turned);
        visit(halves[turned ? 0 : 1], levels - 1, !turned);
    }

    std::uint16_t vertex(GridPoint p)
    {
        const auto next = static_cast<std::uint16_t>(_shape.vertices.size());
        const auto [found, isNew] = _numbers.try_emplace({p.column, p.row}, next);
        if (isNew)
            _shape.vertices.push_back(
                {static_cast<std::uint8_t>(p.column), static_cast<std::uint8_t>(p.row)});
        return found->second;
    }

    PatchShape& _shape;
    std::map<std::pair<int, int>, std::uint16_t> _numbers;
};

std::array<PatchShape, SplitBounds::kMostExponent / 2 + 1> allShapes()
{
    std::array<PatchShape, SplitBounds::kMostExponent / 2 + 1> shapes;
    for (std::size_t i = 0; i < shapes.size(); ++i)
    {
        shapes[i].exponent = static_cast<int>(2 * i);
        Bisection{shapes[i]};
    }
    return shapes;
}

} // namespace

const PatchShape& PatchShape::of(int exponent)
{
    static const auto shapes = allShapes();
    assert(exponent >= 0 && exponent % 2 == 0 && exponent <= SplitBounds::kMostExponent);
    return shapes[static_cast<std::size_t>(exponent / 2)];
}

} // namespace osgTerrainROAM::core
