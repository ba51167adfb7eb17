// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <osgTerrainROAM/core/features/FeatureCells.h>

#include "FeatureShapes.h"

namespace osgTerrainROAM::core
{

/// Cuts shapes into the lists of FeatureCells. Use: layGrid(), fill(), store().
class CellBuilder
{
public:
    CellBuilder(FeatureCells& cells, const FeatureShapes& shapes) : _cells(cells), _shapes(shapes) {}

    /// Lays cells of a size around all shapes. Returns false, and changes nothing, when there would be too
    /// many cells.
    bool layGrid(double cellM);

    /// The largest number of texels that single precision can index.
    static constexpr std::size_t kMostRecords = 1u << 24;

    /// Lists the shapes that touch each cell; gives up above kMostRecords.
    void fill();

    /// Texels of all lists, and the mean number of texels of a list that is not empty.
    std::size_t records() const { return _records; }
    double crowd() const;

    /// Concatenates the lists.
    void store();

private:
    using Texel = std::array<float, 4>;

    /// The list of one cell while it is built.
    struct Draft
    {
        std::uint32_t areas = 0, lines = 0, strokes = 0;
        std::vector<Texel> texels;
    };

    /// First and last cell of a range in metres, along one axis.
    struct Range
    {
        int first, last;
    };

    Range rangeOf(double low, double high, int axis) const;
    glm::dvec2 middleOf(int column, int row) const;
    Draft& draft(int column, int row)
    {
        return _drafts[static_cast<std::size_t>(row) * _cells.columns + column];
    }

    template<class Add>
    void visit(const glm::dvec2& a, const glm::dvec2& b, double around, const Add& add);
    void addArea(const FeatureShapes::Area& area);
    void addEdges(Draft& draft, const FeatureShapes::Area& area, const glm::dvec2& middle,
                  const std::vector<Ring>& rings);

    FeatureCells& _cells;
    const FeatureShapes& _shapes;
    std::vector<Draft> _drafts;
    std::size_t _records = 0;
};

} // namespace osgTerrainROAM::core
