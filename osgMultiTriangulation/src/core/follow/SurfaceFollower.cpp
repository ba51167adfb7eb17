// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <atomic>

#ifdef __linux__
#include <pthread.h>
#include <sched.h>
#endif

#include <osgMultiTriangulation/core/extract/EyeCriterion.h>
#include <osgMultiTriangulation/core/follow/SurfaceFollower.h>
#include <osgMultiTriangulation/core/zone/InterestZone.h>

namespace osgMultiTriangulation::core
{

namespace
{

constexpr double kMostSpare = 50.0; ///< an eye that moves faster has jumped
constexpr double kSpareOfMove = 2.0;

/// Lets a woken thread wait until a processor is free, instead of taking that of the thread which woke it: a
/// frame would wait for it.
void yieldToOthers()
{
#ifdef __linux__
    const sched_param none{};
    pthread_setschedparam(pthread_self(), SCHED_BATCH, &none); // else it stays as it is
#endif
}

} // namespace

SurfaceFollower::SurfaceFollower(MtFile file, double vertexStep)
    : _file(std::move(file)), _frame(_file.info(), vertexStep), _writer(_frame)
{
}

foundation::Result<std::unique_ptr<SurfaceFollower>>
SurfaceFollower::open(MtFile file, const ZoneSettings& settings, double vertexStep)
{
    std::unique_ptr<SurfaceFollower> follower(new SurfaceFollower(std::move(file), vertexStep));
    auto zone = InterestZone::open(follower->_file, settings);
    if (!zone) return zone.error();
    follower->_zone = std::move(*zone);
    follower->_coarsest = std::make_shared<DrawnSurface>();
    follower->_writer.write(follower->_zone->extraction(), *follower->_coarsest);
    follower->_coarsest->serial = 1;
    follower->_serial = 1;
    follower->_zone->removeView(0);
    follower->_thread = std::thread([own = follower.get()] { own->run(); });
    return follower;
}

SurfaceFollower::~SurfaceFollower()
{
    {
        const std::lock_guard lock(_mutex);
        _isEnding = true;
    }
    _isAsked.notify_all();
    if (_thread.joinable()) _thread.join();
}

std::size_t SurfaceFollower::addView()
{
    const std::lock_guard lock(_mutex);
    const auto free = std::ranges::find_if(_views, [](const auto& view) { return !view; });
    const auto number = static_cast<std::size_t>(free - _views.begin());
    if (free == _views.end()) _views.emplace_back();
    _views[number] = std::make_unique<View>();
    _views[number]->newest = _coarsest;
    return number;
}

void SurfaceFollower::removeView(std::size_t view)
{
    {
        const std::lock_guard lock(_mutex);
        _views[view]->isLeft = true;
        _hasWork = true;
    }
    _isAsked.notify_one();
}

std::shared_ptr<const DrawnSurface> SurfaceFollower::follow(std::size_t view, const FollowTarget& target)
{
    std::unique_lock lock(_mutex, std::try_to_lock);
    if (!lock) return nullptr;
    const bool isNew = ask(*_views[view], target);
    const std::shared_ptr<const DrawnSurface> newest = _views[view]->newest;
    lock.unlock();
    if (isNew) _isAsked.notify_one();
    return newest;
}

std::shared_ptr<const DrawnSurface> SurfaceFollower::settle(std::size_t view, const FollowTarget& target)
{
    std::unique_lock lock(_mutex);
    View& own = *_views[view];
    ask(own, target);
    ++_waiting;
    _isAsked.notify_one();
    _isAnswered.wait(lock, [&] { return own.answered >= own.asked; });
    --_waiting;
    return own.newest;
}

/// Returns whether the target is another than before.
bool SurfaceFollower::ask(View& view, const FollowTarget& target)
{
    if (view.target == target) return false;
    view.target = target;
    ++view.asked;
    _hasWork = true;
    return true;
}

FollowFigures SurfaceFollower::figures() const
{
    const std::lock_guard lock(_mutex);
    return _figures;
}

void SurfaceFollower::run()
{
    yieldToOthers();
    std::unique_lock lock(_mutex);
    while (!_isEnding)
    {
        _isAsked.wait(lock, [this] { return _hasWork || _isEnding; });
        if (_isEnding) break;
        _hasWork = false;
        const std::vector<Job> jobs = takeJobs();
        const bool isWaitedFor = _waiting > 0;
        lock.unlock();
        const bool isComplete = work(jobs, isWaitedFor);
        lock.lock();
        for (const Job& job : jobs)
            if (isComplete) job.view->answered = job.asked;
        _hasWork = _hasWork || !isComplete;
        tellFigures();
        if (isComplete) _isAnswered.notify_all();
    }
}

/// Ends the views that were left, and copies the targets of the others.
std::vector<SurfaceFollower::Job> SurfaceFollower::takeJobs()
{
    for (auto& view : _views)
        if (view && view->isLeft)
        {
            if (view->zoneView && !view->isSharing)
            {
                _zone->removeView(*view->zoneView);
                for (auto& other : _views)
                    if (other && other->isSharing && other->zoneView == view->zoneView)
                        other->zoneView.reset();
            }
            view = nullptr;
        }
    std::vector<Job> jobs;
    for (const auto& view : _views)
        if (view && view->target) jobs.push_back({view.get(), *view->target, view->asked});
    return jobs;
}

/// Loads what the eyes want, all of it or (not `isWaitedFor`) one tree, and refines. Returns whether
/// everything wanted is there.
bool SurfaceFollower::work(const std::vector<Job>& jobs, bool isWaitedFor)
{
    std::vector<ZoneEye> eyes;
    for (const Job& job : jobs)
    {
        if (!job.view->zoneView) beginView(*job.view, jobs);
        eyes.push_back({_frame.low[0] + job.target.eye.x / _frame.step.x,
                        _frame.low[1] + job.target.eye.y / _frame.step.y, job.target.errorPerDistance,
                        job.target.nearest});
    }
    const std::uint64_t reads = _zone->reads();
    bool isComplete = true;
    if (isWaitedFor)
        _zone->moveTo(eyes);
    else
        isComplete = _zone->step(eyes);
    const bool hasOtherTrees = _zone->reads() != reads;
    for (const Job& job : jobs)
        if (!job.view->isSharing && (hasOtherTrees || job.view->refinedFor != job.target))
            refine(*job.view, job.target, isWaitedFor);
    for (const Job& job : jobs)
        if (job.view->isSharing) share(*job.view, jobs);
    return isComplete;
}

void SurfaceFollower::beginView(View& view, const std::vector<Job>& jobs)
{
    const std::size_t zoneView = _zone->addView();
    view.isSharing = std::ranges::any_of(jobs, [&](const Job& job)
                                         { return job.view != &view && job.view->zoneView == zoneView; });
    view.zoneView = zoneView;
    view.changes = 0;
    view.refinedFor.reset();
}

void SurfaceFollower::refine(View& view, const FollowTarget& target, bool isWaitedFor)
{
    EyeCriterion criterion{
        target.eye,     _frame.step, {_frame.low[0], _frame.low[1]}, target.errorPerDistance,
        target.nearest, 0.0};
    if (view.refinedFor && !isWaitedFor)
        if (const double moved = glm::distance(view.refinedFor->eye, target.eye); moved < kMostSpare)
            criterion.spare = kSpareOfMove * moved;
    Extraction& extraction = _zone->extraction(*view.zoneView);
    extraction.update(criterion);
    view.refinedFor = target;
    if (extraction.changes() == view.changes) return;
    view.changes = extraction.changes();
    const std::shared_ptr<DrawnSurface> surface = unusedSurface(view);
    _writer.write(extraction, *surface);
    surface->serial = ++_serial;
    const std::lock_guard lock(_mutex);
    view.newest = surface;
}

/// Gives a view for which there is no memory the surface of the view whose extraction it shares.
void SurfaceFollower::share(View& view, const std::vector<Job>& jobs)
{
    const auto owner = std::ranges::find_if(
        jobs, [&](const Job& job) { return !job.view->isSharing && job.view->zoneView == view.zoneView; });
    const std::lock_guard lock(_mutex);
    if (owner != jobs.end()) view.newest = owner->view->newest;
}

/// A surface of the view that nobody draws any more; its memory is used again, so that no frame's thread
/// frees it.
std::shared_ptr<DrawnSurface> SurfaceFollower::unusedSurface(View& view)
{
    const std::lock_guard lock(_mutex);
    for (const auto& surface : view.surfaces)
        if (surface.use_count() == 1)
        {
            // What its last drawer read. ThreadSanitizer knows no fences, and sees that of the copy below.
#ifndef __SANITIZE_THREAD__
            std::atomic_thread_fence(std::memory_order_acquire);
#endif
            return surface;
        }
    return view.surfaces.emplace_back(std::make_shared<DrawnSurface>());
}

void SurfaceFollower::tellFigures()
{
    _figures = {_zone->memoryBytes(), _zone->loadedTrees(), _zone->views(),
                _zone->reads(),       _zone->readBytes(),   _serial,
                _zone->faults()};
}

} // namespace osgMultiTriangulation::core
