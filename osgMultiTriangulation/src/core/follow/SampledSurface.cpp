// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include <osgMultiTriangulation/core/follow/SampledSurface.h>

namespace osgMultiTriangulation::core
{

namespace
{

constexpr double kPointsOfSample = 4.0;

/// Draws trees into the samples, one below the other, so that no more than a way from the main part down is
/// in memory.
class SurfaceSampler
{
public:
    SurfaceSampler(const MtFile& file, int mostSide) : _file(file)
    {
        const MtEntry& main = file.info().trees[0];
        const PlanFrame& frame = file.info().frame;
        const double extentX = double(main.high[0]) - main.low[0],
                     extentY = double(main.high[1]) - main.low[1];
        const bool isLattice = std::max(extentX, extentY) + 1.0 <= mostSide;
        const double few =
            std::clamp(2.0 * std::sqrt(static_cast<double>(file.info().points)), 2.0, mostSide - 1.0);
        const double spacing = std::max(extentX * frame.stepX, extentY * frame.stepY) / few;
        const auto count = [&](double extent, double step) {
            return 1 +
                   static_cast<int>(std::max(1.0, isLattice ? extent : std::round(extent * step / spacing)));
        };
        surface.columns = count(extentX, frame.stepX);
        surface.rows = count(extentY, frame.stepY);
        _pitch[0] = std::max(extentX, 1.0) / (surface.columns - 1);
        _pitch[1] = std::max(extentY, 1.0) / (surface.rows - 1);
        surface.spacingX = _pitch[0] * frame.stepX;
        surface.spacingY = _pitch[1] * frame.stepY;
        const std::size_t samples = std::size_t(surface.columns) * surface.rows;
        surface.heights.assign(samples, 0.0f);
        surface.isThere.assign(samples, 0);
        _share = std::min(1.0, kPointsOfSample * static_cast<double>(samples) /
                                   static_cast<double>(file.info().points));
        surface.lowest = std::numeric_limits<float>::max();
        surface.highest = std::numeric_limits<float>::lowest();
    }

    foundation::Outcome sample(std::uint32_t number, const ReadTree* parent)
    {
        const MtEntry& entry = _file.info().trees[number];
        const bool isLast = _file.childrenOf(number).empty();
        const auto fragments = static_cast<std::size_t>(std::ceil((isLast ? _share : 1.0) * entry.fragments));
        const auto read = _file.read(number, parent, fragments + kSectionFragments - 1); // no less, then
        if (!read) return read.error();
        const MultiTriangulation& tree = read->tree.part;
        for (std::uint32_t t = 0; t < tree.triangleCount(); ++t)
            if (tree.lower[t] == kNone) draw(tree, t);
        for (const std::uint32_t child : _file.childrenOf(number))
            static_cast<void>(sample(child, &*read)); // where one is damaged its parent shows
        return foundation::success();
    }

    /// Fills samples without surface from those beside them.
    void fill()
    {
        std::vector<std::uint8_t> isKnown = surface.isThere;
        const auto take = [&](std::size_t from, std::size_t to)
        {
            if (isKnown[to] || !isKnown[from]) return;
            surface.heights[to] = surface.heights[from];
            isKnown[to] = 1;
        };
        const auto columns = static_cast<std::size_t>(surface.columns), all = surface.heights.size();
        for (std::size_t i = 1; i < all; ++i)
            if (i % columns != 0) take(i - 1, i);
        for (std::size_t i = all - 1; i-- > 0;)
            if ((i + 1) % columns != 0) take(i + 1, i);
        for (std::size_t i = columns; i < all; ++i)
            take(i - columns, i);
        for (std::size_t i = all - columns; i-- > 0;)
            take(i + columns, i);
    }

    SampledSurface surface;

private:
    /// Places on the grid are no whole numbers of the lattice: a sample on a side counts as inside.
    void draw(const MultiTriangulation& tree, std::uint32_t triangle)
    {
        const MtEntry& main = _file.info().trees[0];
        double x[3], y[3], z[3];
        for (int c = 0; c < 3; ++c)
        {
            const SurfacePoint& p = tree.points[tree.corners[triangle][c]];
            x[c] = (double(p.x) - main.low[0]) / _pitch[0];
            y[c] = (double(p.y) - main.low[1]) / _pitch[1];
            z[c] = p.height;
            surface.lowest = std::min(surface.lowest, static_cast<float>(p.height) - tree.errors[triangle]);
            surface.highest = std::max(surface.highest, static_cast<float>(p.height) + tree.errors[triangle]);
        }
        const double area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
        const double slack = -1e-9 * area;
        const int west = std::max(0, static_cast<int>(std::ceil(std::min({x[0], x[1], x[2]}) - 1e-9)));
        const int east =
            std::min(surface.columns - 1, static_cast<int>(std::floor(std::max({x[0], x[1], x[2]}) + 1e-9)));
        const int south = std::max(0, static_cast<int>(std::ceil(std::min({y[0], y[1], y[2]}) - 1e-9)));
        const int north =
            std::min(surface.rows - 1, static_cast<int>(std::floor(std::max({y[0], y[1], y[2]}) + 1e-9)));
        for (int row = south; row <= north; ++row)
            for (int column = west; column <= east; ++column)
            {
                double on[3];
                for (int c = 0; c < 3; ++c)
                {
                    const int a = (c + 1) % 3, b = (c + 2) % 3;
                    on[c] = (x[a] - column) * (y[b] - row) - (y[a] - row) * (x[b] - column);
                }
                if (on[0] < slack || on[1] < slack || on[2] < slack) continue;
                const std::size_t i = std::size_t(row) * surface.columns + column;
                surface.heights[i] = static_cast<float>((on[0] * z[0] + on[1] * z[1] + on[2] * z[2]) / area);
                surface.isThere[i] = 1;
            }
    }

    const MtFile& _file;
    double _pitch[2] = {1.0, 1.0}, _share = 1.0;
};

} // namespace

foundation::Result<SampledSurface> sampleSurface(const MtFile& file, int mostSide)
{
    SurfaceSampler sampler(file, mostSide);
    if (const auto sampled = sampler.sample(0, nullptr); !sampled) return sampled.error();
    sampler.fill();
    return std::move(sampler.surface);
}

} // namespace osgMultiTriangulation::core
