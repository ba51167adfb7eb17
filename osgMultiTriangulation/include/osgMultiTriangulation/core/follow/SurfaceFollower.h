// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/file/MtFile.h>
#include <osgMultiTriangulation/core/follow/DrawnSurface.h>
#include <osgMultiTriangulation/core/zone/ZoneSettings.h>

namespace osgMultiTriangulation::core
{

class InterestZone;

/// What a view asks for. Frame and units: DrawnSurface.
struct FollowTarget
{
    glm::dvec3 eye{0.0};
    double errorPerDistance = 0.0; ///< pixels allowed per pixels a unit of tangent has
    double nearest = 1.0;

    bool operator==(const FollowTarget&) const = default;
};

/// What following came to so far.
struct FollowFigures
{
    std::size_t memoryBytes = 0, loadedTrees = 0, views = 0;
    std::uint64_t reads = 0, readBytes = 0, surfaces = 0;
    std::vector<std::string> faults; ///< of the file, each told once
};

/// Keeps a drawn surface of a file up to date for each of several moving eyes. A thread of its own reads
/// trees, refines and writes the vertices; who draws takes the surface that is ready. A surface is always a
/// triangulation of everything. While the eye moves it is one or a few frames old: it was refined for an eye
/// that may move on by twice as far as it last did meanwhile; where trees are not read yet it is coarser.
/// Threads: any. Only settle() waits for the disk or for refinement.
class SurfaceFollower
{
public:
    /// Errors: the main part is damaged, or does not fit the memory.
    static foundation::Result<std::unique_ptr<SurfaceFollower>>
    open(MtFile file, const ZoneSettings& settings, double vertexStep);
    ~SurfaceFollower();
    SurfaceFollower(const SurfaceFollower&) = delete;
    SurfaceFollower& operator=(const SurfaceFollower&) = delete;

    /// Begins a view, and returns its number. It has the coarsest surface at once.
    std::size_t addView();
    void removeView(std::size_t view);

    /// Tells where the eye of a view is, and returns the newest surface of this view; null where the thread
    /// is just changing it: then the caller keeps what it has, and tells the eye the next time. Never waits.
    std::shared_ptr<const DrawnSurface> follow(std::size_t view, const FollowTarget& target);

    /// The same, and waits until trees and detail are as the target needs. The same targets give the same
    /// surfaces.
    std::shared_ptr<const DrawnSurface> settle(std::size_t view, const FollowTarget& target);

    /// The surface with no detail at all.
    std::shared_ptr<const DrawnSurface> coarsest() const { return _coarsest; }

    FollowFigures figures() const;
    const MtFile& file() const { return _file; }
    const DrawnFrame& frame() const { return _frame; }

private:
    struct View
    {
        std::optional<FollowTarget> target;
        std::uint64_t asked = 0, answered = 0; ///< counts of targets
        std::shared_ptr<DrawnSurface> newest;
        bool isLeft = false;
        // Of the thread alone:
        std::optional<std::size_t> zoneView;
        bool isSharing = false; ///< the zone's view is another's
        std::optional<FollowTarget> refinedFor;
        std::uint64_t changes = 0;
        std::vector<std::shared_ptr<DrawnSurface>> surfaces;
    };
    struct Job
    {
        View* view;
        FollowTarget target;
        std::uint64_t asked;
    };

    SurfaceFollower(MtFile file, double vertexStep);

    bool ask(View& view, const FollowTarget& target);
    void run();
    std::vector<Job> takeJobs();
    bool work(const std::vector<Job>& jobs, bool isWaitedFor);
    void beginView(View& view, const std::vector<Job>& jobs);
    void refine(View& view, const FollowTarget& target, bool isWaitedFor);
    void share(View& view, const std::vector<Job>& jobs);
    std::shared_ptr<DrawnSurface> unusedSurface(View& view);
    void tellFigures();

    MtFile _file;
    DrawnFrame _frame;
    SurfaceWriter _writer;
    std::unique_ptr<InterestZone> _zone;
    std::shared_ptr<DrawnSurface> _coarsest;
    std::uint64_t _serial = 0;
    mutable std::mutex _mutex; ///< guards what follows, and what is not the thread's of each view
    std::condition_variable _isAsked, _isAnswered;
    std::vector<std::unique_ptr<View>> _views;
    FollowFigures _figures;
    std::size_t _waiting = 0; ///< number of threads in settle()
    bool _hasWork = false, _isEnding = false;
    std::thread _thread;
};

} // namespace osgMultiTriangulation::core
