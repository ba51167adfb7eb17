// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>
#include <type_traits>
#include <vector>

#include <osgPMObjects/core/progressive/CompactedLevel.h>
#include <osgPMObjects/core/progressive/LevelMesh.h>

namespace osgPMObjects::core
{

/// The interface of the pass over the faces, for both widths of indices.
class CompactedLevel::Pass
{
public:
    virtual ~Pass() = default;

    virtual void moveTo(std::uint32_t steps) = 0;
    virtual bool hasNarrowIndices() const = 0;
    virtual std::span<const std::uint16_t> narrowIndices() const = 0;
    virtual std::span<const std::uint32_t> wideIndices() const = 0;

    std::uint32_t groupCount() const { return static_cast<std::uint32_t>(_groupEnds.size()); }
    std::uint32_t triangleCount() const { return _groupEnds.empty() ? 0 : _groupEnds.back(); }

    SlotRange rangeOf(std::uint32_t group) const
    {
        const std::uint32_t first = group == 0 ? 0 : _groupEnds[group - 1];
        return {first, _groupEnds[group] - first};
    }

protected:
    std::vector<std::uint32_t> _groupEnds;
};

namespace
{

/// Returns the number of steps after which a face has vanished: a corner is lost, or two corners have one
/// position. One more than the number of all steps: never.
std::uint32_t endOf(const ProgressiveMesh& progressive, Triangle face)
{
    const auto& positions = progressive.mesh.wedgePositions;
    while (true)
    {
        std::uint32_t& next = *std::max_element(face.begin(), face.end()); // the last wedge is removed first
        const std::uint32_t goesAfter =
            static_cast<std::uint32_t>(progressive.mesh.positions.size()) - positions[next];
        if (goesAfter > progressive.stepCount) return progressive.stepCount + 1;
        if (progressive.parents[next] == next) return goesAfter;
        next = progressive.parents[next];
        const std::uint32_t a = positions[face[0]], b = positions[face[1]], c = positions[face[2]];
        if (a == b || b == c || c == a) return goesAfter;
    }
}

template<class Index>
class IndexPass : public CompactedLevel::Pass
{
public:
    explicit IndexPass(const ProgressiveMesh& progressive)
        : _progressive(progressive),
          _parents(progressive.parents.begin(), progressive.parents.end()),
          _become(progressive.parents.size())
    {
        ProgressiveLevel finest(progressive);
        finest.moveTo(0);
        _faces.reserve(finest.faceCount());
        _finestEnds.resize(progressive.groups.size(), 0);
        const auto index = [](std::uint32_t number) { return static_cast<Index>(number); };
        forEachDrawnFace(progressive, finest,
                         [&](const Triangle& face, std::uint32_t group)
                         {
                             _faces.push_back({index(face[0]), index(face[1]), index(face[2]),
                                               index(endOf(progressive, face))});
                             ++_finestEnds[group];
                         });
        std::partial_sum(_finestEnds.begin(), _finestEnds.end(), _finestEnds.begin());
        _groupEnds = _finestEnds;
        _indices.resize(3 * _faces.size());
        IndexPass::moveTo(0);
    }

    /// Vanished faces are written, too, and the next face overwrites them: a branch could not be predicted.
    /// Three plain stores are used, for one combined word would make each face wait for the one before, which
    /// takes half as long again.
    void moveTo(std::uint32_t steps) override
    {
        findWedges(_progressive.wedgesAfter(steps));
        const Index* const become = _become.data();
        const Face* face = _faces.data();
        Index* out = _indices.data();
        for (std::size_t group = 0; group < _groupEnds.size(); ++group)
        {
            for (const Face* const end = _faces.data() + _finestEnds[group]; face != end; ++face)
            {
                out[0] = become[face->a];
                out[1] = become[face->b];
                out[2] = become[face->c];
                out += face->end > steps ? 3 : 0;
            }
            _groupEnds[group] = static_cast<std::uint32_t>((out - _indices.data()) / 3);
        }
    }

    bool hasNarrowIndices() const override { return std::is_same_v<Index, std::uint16_t>; }
    std::span<const std::uint16_t> narrowIndices() const override { return indicesAs<std::uint16_t>(); }
    std::span<const std::uint32_t> wideIndices() const override { return indicesAs<std::uint32_t>(); }

private:
    /// A face of the finest level, and the number of steps after which it vanishes.
    struct Face
    {
        Index a, b, c, end;
    };

    template<class Wanted>
    std::span<const Wanted> indicesAs() const
    {
        if constexpr (std::is_same_v<Wanted, Index>)
            return {_indices.data(), std::size_t{3} * triangleCount()};
        else
            return {};
    }

    void findWedges(std::uint32_t wedgesLeft)
    {
        if (wedgesLeft > _wedgesLeft)
            std::iota(_become.begin() + _wedgesLeft, _become.begin() + wedgesLeft,
                      static_cast<Index>(_wedgesLeft));
        _wedgesLeft = wedgesLeft;
        for (std::size_t wedge = wedgesLeft; wedge < _become.size(); ++wedge)
            _become[wedge] = _become[_parents[wedge]];
    }

    const ProgressiveMesh& _progressive;
    std::vector<Face> _faces;
    std::vector<std::uint32_t> _finestEnds; ///< by group, in `_faces`
    std::vector<Index> _parents;
    std::vector<Index> _become; ///< by wedge: its replacement; undefined for lost wedges
    std::uint32_t _wedgesLeft = 0;
    std::vector<Index> _indices; ///< capacity for the finest level
};

} // namespace

CompactedLevel::CompactedLevel(const ProgressiveMesh& progressive)
{
    if (progressive.mesh.wedgeCount() < std::numeric_limits<std::uint16_t>::max())
        _pass = std::make_unique<IndexPass<std::uint16_t>>(progressive);
    else
        _pass = std::make_unique<IndexPass<std::uint32_t>>(progressive);
}

CompactedLevel::~CompactedLevel() = default;
CompactedLevel::CompactedLevel(CompactedLevel&&) noexcept = default;
CompactedLevel& CompactedLevel::operator=(CompactedLevel&&) noexcept = default;

void CompactedLevel::moveTo(std::uint32_t steps)
{
    _pass->moveTo(steps);
}

bool CompactedLevel::hasNarrowIndices() const
{
    return _pass->hasNarrowIndices();
}

std::span<const std::uint16_t> CompactedLevel::narrowIndices() const
{
    return _pass->narrowIndices();
}

std::span<const std::uint32_t> CompactedLevel::wideIndices() const
{
    return _pass->wideIndices();
}

std::uint32_t CompactedLevel::triangleCount() const
{
    return _pass->triangleCount();
}

Triangle CompactedLevel::triangle(std::uint32_t index) const
{
    const auto at = [&](const auto& indices) -> Triangle
    {
        return {indices[3 * std::size_t{index}], indices[3 * std::size_t{index} + 1],
                indices[3 * std::size_t{index} + 2]};
    };
    return hasNarrowIndices() ? at(narrowIndices()) : at(wideIndices());
}

std::uint32_t CompactedLevel::groupCount() const
{
    return _pass->groupCount();
}

SlotRange CompactedLevel::rangeOf(std::uint32_t group) const
{
    return _pass->rangeOf(group);
}

} // namespace osgPMObjects::core
