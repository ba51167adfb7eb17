// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <map>
#include <memory>

#include <osgMultiTriangulation/core/extract/Extraction.h>
#include <osgMultiTriangulation/core/structure/ErrorCode.h>
#include <osgMultiTriangulation/core/zone/ExtractFromFile.h>

namespace osgMultiTriangulation::core
{

namespace
{

/// A region on the lattice.
struct LatticeRegion
{
    double low[2] = {std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};
    double high[2] = {std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};

    bool meets(const SurfacePoint& a, const SurfacePoint& b, const SurfacePoint& c) const
    {
        return std::max({a.x, b.x, c.x}) >= low[0] && std::min({a.x, b.x, c.x}) <= high[0] &&
               std::max({a.y, b.y, c.y}) >= low[1] && std::min({a.y, b.y, c.y}) <= high[1];
    }

    bool meets(const MtEntry& tree) const
    {
        return tree.high[0] >= low[0] && tree.low[0] <= high[0] && tree.high[1] >= low[1] &&
               tree.low[1] <= high[1];
    }
};

LatticeRegion onLattice(const std::optional<PlanRegion>& region, const PlanFrame& frame)
{
    if (!region) return {};
    const PlanFrame units = inReference(frame);
    return {{(region->west - units.originX) / units.stepX, (region->south - units.originY) / units.stepY},
            {(region->east - units.originX) / units.stepX, (region->north - units.originY) / units.stepY}};
}

/// A triangle is too coarse when it meets the region and has more than an error.
struct RegionCriterion
{
    LatticeRegion region;
    float errorM = 0.0f;

    bool operator()(const MultiTriangulation& tree, std::uint32_t triangle) const
    {
        const Triangle& c = tree.corners[triangle];
        return tree.errors[triangle] > errorM &&
               region.meets(tree.points[c[0]], tree.points[c[1]], tree.points[c[2]]);
    }
};

/// The trees of a file that are needed, in memory.
class NeededTrees
{
public:
    foundation::Outcome read(const MtFile& file, const LatticeRegion& region, float errorM)
    {
        const std::vector<MtEntry>& trees = file.info().trees;
        std::vector<float> errors; // by tree: the greatest of its root and of those below
        for (const MtEntry& tree : trees)
            errors.push_back(tree.rootError);
        for (std::size_t t = trees.size(); t-- > 1;)
            errors[trees[t].parent] = std::max(errors[trees[t].parent], errors[t]);
        for (std::uint32_t t = 0; t < trees.size(); ++t)
        {
            const auto parent = t == 0 ? _trees.end() : _trees.find(trees[t].parent);
            const bool isNeeded = parent != _trees.end() && region.meets(trees[t]) && errors[t] > errorM;
            if (t != 0 && !isNeeded) continue;
            auto tree = file.read(t, t == 0 ? nullptr : parent->second.get());
            if (!tree) return tree.error();
            _trees.emplace(t, std::make_unique<ReadTree>(std::move(*tree)));
        }
        return foundation::success();
    }

    /// Takes a triangulation from the root down, so that it does not depend on what was taken before.
    Extraction at(const RegionCriterion& criterion) const
    {
        Extraction extraction(_trees.at(0)->tree);
        for (const auto& [number, read] : _trees) // parents come before children
            if (number != 0) extraction.attach(number, read->tree);
        extraction.refine(criterion);
        return extraction;
    }

    std::size_t count() const { return _trees.size(); }

private:
    std::map<std::uint32_t, std::unique_ptr<ReadTree>> _trees;
};

} // namespace

foundation::Result<ExtractedSurface> extractFrom(const MtFile& file, const ExtractRequest& request)
{
    RegionCriterion criterion{onLattice(request.region, file.info().frame),
                              static_cast<float>(request.errorM)};
    NeededTrees trees;
    if (const auto outcome = trees.read(file, criterion.region, criterion.errorM); !outcome)
        return outcome.error();
    const auto countAt = [&](std::uint32_t code)
    {
        criterion.errorM = errorOfCode(static_cast<std::uint16_t>(code));
        return trees.at(criterion).active().size();
    };
    Extraction extraction = trees.at(criterion);
    if (extraction.active().size() > request.mostTriangles)
    {
        // What is applied for an error is applied for each lesser one, so the number falls as the error
        // grows.
        std::uint32_t low = codeOfError(criterion.errorM), high = 0xffff;
        if (const std::size_t least = countAt(high); least > request.mostTriangles)
            return foundation::Error{file.path().string(),
                                     "has " + std::to_string(least) + " triangles where it is coarsest",
                                     "allow more triangles"};
        while (high - low > 1)
        {
            const std::uint32_t middle = (low + high) / 2;
            (countAt(middle) > request.mostTriangles ? low : high) = middle;
        }
        criterion.errorM = errorOfCode(static_cast<std::uint16_t>(high));
        extraction = trees.at(criterion);
    }
    return ExtractedSurface{extraction.mesh(), std::max(criterion.errorM, 0.0f), trees.count()};
}

} // namespace osgMultiTriangulation::core
