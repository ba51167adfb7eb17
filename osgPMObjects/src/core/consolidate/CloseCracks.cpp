// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include <osgPMObjects/core/consolidate/CloseCracks.h>

#include "EdgeCells.h"
#include "Excerpt.h"
#include "MeshSnapshot.h"

namespace osgPMObjects::core
{

namespace
{

/// Passes after which flat faces between vertices on one line are removed, not cut: each pass could cut them
/// into faces that the next removes, without end.
constexpr int kPatientPasses = 6;
/// Factor of the tolerance for neighbourhoods: vertices and edges within the tolerance affect each other; the
/// rest is for rounding.
constexpr double kReach = 2.0;

void add(DuplicateFaces& sum, const DuplicateFaces& more)
{
    sum.removed += more.removed;
    sum.hidden += more.hidden;
    sum.backToBack += more.backToBack;
}

void add(TVertices& sum, const TVertices& more)
{
    sum.inserted += more.inserted;
    sum.stitched += more.stitched;
    sum.slivers += more.slivers;
    sum.moved += more.moved;
}

void insert(std::vector<std::uint32_t>& sorted, const std::vector<std::uint32_t>& more)
{
    sorted.insert(sorted.end(), more.begin(), more.end());
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
}

/// The mesh, or an excerpt of one, that passes examine.
struct Ground
{
    Mesh& mesh;
    TVertexState& state;
    std::vector<std::uint32_t>& changed; ///< positions of changed faces, for the next pass
};

/// Makes one pass over all of it. Returns whether it changed anything, and for each face the number that it
/// had or comes from.
bool passOver(const Ground& on, double degenerateHeight, ClosedCracks& report,
              std::vector<std::uint32_t>& origins)
{
    const MeshSnapshot before(on.mesh);
    const FaceOrigins numbers(on.mesh);
    report.degenerateFaces += removeDegenerateFaces(on.mesh, degenerateHeight);
    add(report.duplicates, removeDuplicateFaces(on.mesh));
    const TVertices pass = insertTVertices(on.mesh, on.state);
    add(report.tVertices, pass);
    origins = numbers.giveBack(on.mesh);
    on.changed = before.changedSince(on.mesh, origins);
    insert(on.changed, on.state.waiting);
    return !pass.isNothing();
}

/// An excerpt to examine, whose changes are put back into the mesh it comes from.
class Plot
{
public:
    Plot(const Ground& whole, std::span<const std::uint8_t> isWanted)
        : _whole(whole), _excerpt(whole.mesh, isWanted)
    {
        const std::vector<std::uint32_t>& positions = _excerpt.positions();
        _state.tolerance = whole.state.tolerance;
        _state.mostNewFaces = whole.state.mostNewFaces;
        whole.state.noteHomes(whole.mesh.positions);
        for (const std::uint32_t p : positions)
            _state.homes.push_back(whole.state.homes[p]);
        for (const std::uint32_t p : whole.changed)
        {
            const auto found = std::lower_bound(positions.begin(), positions.end(), p);
            if (found != positions.end() && *found == p)
                _changed.push_back(static_cast<std::uint32_t>(found - positions.begin()));
        }
    }

    Ground ground() { return {_excerpt.mesh, _state, _changed}; }
    const Excerpt& excerpt() const { return _excerpt; }

    void putBack(std::span<const std::uint32_t> origins)
    {
        const std::vector<std::uint32_t>& positions = _excerpt.positions();
        for (std::size_t p = 0; p < positions.size(); ++p)
            _whole.state.homes[positions[p]] = _state.homes[p];
        _whole.state.mostNewFaces = _state.mostNewFaces;
        _whole.state.isAtLimit = _whole.state.isAtLimit || _state.isAtLimit;
        _excerpt.putBack(_whole.mesh, origins);
        _whole.changed.clear();
        for (const std::uint32_t p : _changed)
            _whole.changed.push_back(positions[p]);
    }

private:
    Ground _whole;
    Excerpt _excerpt;
    TVertexState _state;
    std::vector<std::uint32_t> _changed;
};

/// Makes one pass over the faces near changes. Returns whether it changed anything.
bool passNear(const Ground& on, const EdgeCells& near, double degenerateHeight, ClosedCracks& report)
{
    Plot plot(on, near.facesTouching(on.mesh));
    plot.ground().state.thinHeight = on.state.thinHeight;
    plot.ground().state.among = plot.excerpt().isInner();
    std::vector<std::uint32_t> origins;
    const bool didAnything = passOver(plot.ground(), degenerateHeight, report, origins);
    plot.putBack(origins);
    return didAnything;
}

/// Begins the next pass; returns false when there is none.
bool begin(CrackPasses& passes, TVertexState& state)
{
    if (passes.made >= passes.most) return false;
    if (++passes.made > kPatientPasses) state.thinHeight = state.tolerance;
    return true;
}

/// Makes passes in a wider excerpt, as long as none needs faces beyond it. Returns whether the last one
/// changed anything.
bool passesAround(const Ground& on, CrackPasses& passes, ClosedCracks& report)
{
    const Extent extent = extentOf(on.mesh.positions);
    const double reach = kReach * on.state.tolerance;
    EdgeCells wide(extent, reach);
    wide.markAround(on.mesh, on.changed);
    wide.markFaces(on.mesh, wide.facesTouching(on.mesh));
    Plot plot(on, wide.facesTouching(on.mesh));
    const Ground inside = plot.ground();
    const FaceOrigins numbers(inside.mesh);
    for (bool isMore = true; isMore;)
    {
        EdgeCells near(extent, reach);
        near.markAround(inside.mesh, inside.changed);
        if (!near.isWithin(wide) || !begin(passes, inside.state))
        {
            plot.putBack(numbers.giveBack(inside.mesh));
            return true;
        }
        isMore = passNear(inside, near, passes.degenerateHeight, report);
    }
    plot.putBack(numbers.giveBack(inside.mesh));
    return false;
}

} // namespace

ClosedCracks closeCracks(Mesh& mesh, CrackPasses& passes)
{
    ClosedCracks report;
    const Ground all{mesh, passes.tVertices, passes.changed};
    for (bool isMore = true; isMore && passes.made < passes.most;)
    {
        const auto few = passes.wholeShare * static_cast<double>(mesh.positions.size());
        if (passes.isWhole || static_cast<double>(passes.changed.size()) > few)
        {
            begin(passes, all.state);
            std::vector<std::uint32_t> origins;
            isMore = passOver(all, passes.degenerateHeight, report, origins);
        }
        else
            isMore = passesAround(all, passes, report);
        passes.isWhole = false;
    }
    DuplicateFaces last = removeDuplicateFaces(mesh); // for the count of kept pairs, in the whole mesh
    add(last, report.duplicates);
    report.duplicates = last;
    return report;
}

} // namespace osgPMObjects::core
