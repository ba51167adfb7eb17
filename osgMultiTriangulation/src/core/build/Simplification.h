// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <queue>
#include <span>
#include <vector>

#include <osgMultiTriangulation/core/build/BuildTree.h>

#include "LiveSurface.h"

namespace osgMultiTriangulation::core
{

/// How the hole of a removed vertex is filled: by the triangulation with the least error, or by the best fan
/// around one of its corners, so that the removal is a half-edge collapse.
enum class Filling
{
    best,
    fan,
};

/// A vertex that was removed. Numbers of triangles are by creation, the input's first.
struct Removal
{
    std::uint32_t vertex = 0;
    std::uint32_t firstStar = 0;    ///< in Simplification::stars()
    std::uint32_t firstCreated = 0; ///< the triangles of the hole
    std::uint32_t apex = kNone;     ///< of a fan: the vertex that all triangles of the hole have
    std::uint8_t starCount = 0, createdCount = 0;
};

/// Removes vertices in the order of the error that each leaves, and records what it did. See buildTree().
/// Threads: one.
class Simplification
{
public:
    Simplification(const MeasuredMesh& input, const std::vector<bool>& isLocked,
                   Filling filling = Filling::best);

    /// Removes vertices until no more than `keep` are left, or none can go.
    void run(std::size_t keep);

    std::span<const Removal> removals() const { return _removals; }
    std::span<const std::uint32_t> stars() const { return _stars; }
    std::span<const Triangle> corners() const { return _corners; } ///< by number
    std::span<const float> errors() const { return _errors; }      ///< by number
    const LiveSurface& surface() const { return _surface; }

private:
    struct Candidate
    {
        double squares;
        float error;
        std::uint32_t vertex, version;
        std::uint32_t filling; ///< how its hole is filled, a code of HoleTriangulation, once it is judged

        bool operator<(const Candidate& other) const; ///< less urgent
    };

    bool isCurrent(const Candidate& candidate) const
    {
        return candidate.version == _versions[candidate.vertex];
    }
    bool judge(std::uint32_t vertex, Candidate& candidate);
    void measure(Candidate& candidate);
    bool gatherHole(std::uint32_t vertex);
    bool solve();
    void fill(const Candidate& candidate);
    bool isNext(const Candidate& candidate);
    void push(const Candidate& candidate);
    void remove(const Candidate& candidate);

    Filling _filling;
    LiveSurface _surface;
    HoleTriangulation _hole;
    HoleMeasure _measure;
    LiveStar _star;
    std::array<HoleTriangulation::Point, LiveStar::kMost> _ring; ///< corners of the hole, from the vertex
    HoleTriangulation::Pieces _pieces;
    std::vector<std::uint8_t> _pieceOf; ///< by point of the hole: the vertex, those of its star
    std::priority_queue<Candidate> _queue;
    std::vector<std::uint32_t> _versions; ///< by vertex: an entry of the queue with another one is stale
    enum class State : std::uint8_t
    {
        judged,  ///< its entry in the queue tells its error
        changed, ///< its neighbours have changed since
        stays,   ///< it is not in the queue until its neighbours change
        locked,
    };
    std::vector<State> _states; ///< by vertex
    float _reached = 0.0f;      ///< the greatest error of a removal so far

    std::size_t _left;
    std::vector<Removal> _removals;
    std::vector<std::uint32_t> _stars;
    std::vector<Triangle> _corners;
    std::vector<float> _errors;
};

} // namespace osgMultiTriangulation::core
