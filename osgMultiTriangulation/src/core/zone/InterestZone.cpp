// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>
#include <thread>

#include <osgMultiTriangulation/core/zone/InterestZone.h>

namespace osgMultiTriangulation::core
{

InterestZone::InterestZone(const MtFile& file, const ZoneSettings& settings)
    : _file(file), _settings(settings), _index(file.info().trees)
{
    const std::vector<MtEntry>& trees = file.info().trees;
    _isDamaged.assign(trees.size(), false);
    for (const MtEntry& tree : trees)
        _errors.push_back(tree.rootError);
    for (std::size_t t = trees.size(); t-- > 1;)
        _errors[trees[t].parent] = std::max(_errors[trees[t].parent], _errors[t]);
    _greatestError = _errors[0];
}

foundation::Result<std::unique_ptr<InterestZone>> InterestZone::open(const MtFile& file,
                                                                     const ZoneSettings& settings)
{
    std::unique_ptr<InterestZone> zone(new InterestZone(file, settings));
    const MtEntry& main = file.info().trees[0];
    if (bytesOf(main, main.fragments) > settings.memoryBytes)
        return foundation::Error{file.path().string(),
                                 "its main part needs " + std::to_string(bytesOf(main, main.fragments)) +
                                     " bytes",
                                 "allow more memory, or build it with more --trees"};
    auto read = file.read(0, nullptr);
    if (!read) return read.error();
    zone->_reads = 1;
    zone->_readBytes = main.bytes;
    const auto [loaded, isNew] = zone->_loaded.emplace(0, std::make_unique<ReadTree>(std::move(*read)));
    zone->_extractions.push_back(std::make_unique<Extraction>(loaded->second->tree));
    zone->countMemory();
    return zone;
}

std::size_t InterestZone::bytesOf(const MtEntry& tree, std::size_t fragments, std::size_t views)
{
    // By triangle: corners, error, two links; in each extraction its place there, and itself in a child. By
    // fragment: itself, its floor, its point, two triangles of the drain that are roots of children; a bit in
    // each extraction.
    const std::size_t rootPoints = tree.points - std::min(tree.points, tree.fragments);
    return (24 + 12 * views) * (tree.rootTriangles + 6 * fragments) + (55 + views) * fragments +
           24 * rootPoints + 8 * tree.rootTriangles;
}

std::size_t InterestZone::views() const
{
    return static_cast<std::size_t>(std::ranges::count_if(_extractions, [](const auto& e) { return !!e; }));
}

/// Returns the trees but the main part that an eye may want, with their distance from the nearest of these
/// eyes, in the order in which they have the memory: a parent is no farther than its children, and has a
/// lower number.
std::vector<std::pair<double, std::uint32_t>> InterestZone::inReach(std::span<const ZoneEye> eyes) const
{
    const std::vector<MtEntry>& trees = _file.info().trees;
    std::map<std::uint32_t, double> distances;
    for (const ZoneEye& eye : eyes)
    {
        double reach = _settings.nothingBeyond;
        if (eye.errorPerDistance > 0.0) reach = std::min(reach, _greatestError / eye.errorPerDistance);
        const PlanFrame& frame = _file.info().frame;
        for (const std::uint32_t t : _index.near(eye.x, eye.y, reach / frame.stepX, reach / frame.stepY))
        {
            const double distance = distanceTo(trees[t], eye.x, eye.y, frame.stepX, frame.stepY);
            const bool isWanted = t != 0 && distance < _settings.nothingBeyond &&
                                  _errors[t] > eye.errorPerDistance * std::max(distance, eye.nearest);
            if (!isWanted) continue;
            const auto [place, isNew] = distances.try_emplace(t, distance);
            place->second = std::min(place->second, distance);
        }
    }
    std::vector<std::pair<double, std::uint32_t>> byDistance;
    for (const auto& [tree, distance] : distances)
        byDistance.emplace_back(distance, tree);
    std::ranges::sort(byDistance);
    return byDistance;
}

/// Decides what is loaded: how many fragments of each tree, the main part's always.
InterestZone::Plan InterestZone::planFor(std::span<const ZoneEye> eyes, std::size_t views) const
{
    const std::vector<MtEntry>& trees = _file.info().trees;
    Plan plan{{{0, trees[0].fragments}}, {}};
    std::size_t bytes = bytesOf(trees[0], trees[0].fragments, views);
    for (const auto& [distance, t] : inReach(eyes))
    {
        const auto parent = plan.wanted.find(trees[t].parent);
        if (_isDamaged[t] || parent == plan.wanted.end()) continue;
        const double range = std::max(_settings.nothingBeyond - _settings.completeWithin, 1e-9);
        const double level = std::min(1.0, (_settings.nothingBeyond - distance) / range);
        const auto fragments = static_cast<std::uint32_t>(std::lround(level * trees[t].fragments));
        const MtEntry& above = trees[trees[t].parent];
        const std::size_t more = bytesOf(trees[t], fragments, views) +
                                 bytesOf(above, above.fragments, views) -
                                 bytesOf(above, parent->second, views);
        if (fragments == 0 || bytes + more > _settings.memoryBytes) continue;
        parent->second = above.fragments;
        plan.wanted[t] = fragments;
        plan.order.push_back(t);
        bytes += more;
    }
    return plan;
}

/// Whether a loaded tree may stay as it is.
bool InterestZone::isNearEnough(std::uint32_t tree, std::uint32_t wanted) const
{
    const double now = static_cast<double>(_loaded.at(tree)->tree.part.fragments.size());
    const std::uint32_t all = _file.info().trees[tree].fragments;
    if (wanted == all) return now == all;
    return std::abs(now - wanted) <= _settings.hysteresis * wanted && now <= wanted;
}

void InterestZone::moveTo(double x, double y)
{
    const ZoneEye eye{x, y, 0.0};
    moveTo(std::span(&eye, 1));
}

void InterestZone::moveTo(std::span<const ZoneEye> eyes)
{
    while (!step(eyes))
    {
    }
}

bool InterestZone::step(std::span<const ZoneEye> eyes)
{
    _eyes.assign(eyes.begin(), eyes.end());
    const Plan plan = planFor(eyes, views());
    dropUnwanted(plan.wanted);
    for (const std::uint32_t tree : plan.order)
        if (!_loaded.contains(tree))
        {
            load(tree, plan.wanted.at(tree));
            return false;
        }
    return true;
}

std::size_t InterestZone::addView()
{
    const std::size_t more = views() + 1;
    const MtEntry& main = _file.info().trees[0];
    if (bytesOf(main, main.fragments, more) > _settings.memoryBytes)
        return static_cast<std::size_t>(
            std::ranges::find_if(_extractions, [](const auto& e) { return !!e; }) - _extractions.begin());
    dropUnwanted(planFor(_eyes, more).wanted);
    const auto free = std::ranges::find_if(_extractions, [](const auto& e) { return !e; });
    const auto view = static_cast<std::size_t>(free - _extractions.begin());
    if (free == _extractions.end()) _extractions.emplace_back();
    _extractions[view] = std::make_unique<Extraction>(_loaded.at(0)->tree);
    for (const auto& [number, read] : _loaded) // parents come before children
        if (number != 0) _extractions[view]->attach(number, read->tree);
    countMemory();
    return view;
}

void InterestZone::dropUnwanted(const Wanted& wanted)
{
    std::set<std::uint32_t> leaving;
    for (const auto& [tree, loaded] : _loaded) // parents come before children
    {
        const auto found = wanted.find(tree);
        const std::uint32_t parent = _file.info().trees[tree].parent;
        if (found == wanted.end() || !isNearEnough(tree, found->second) || leaving.contains(parent))
            leaving.insert(tree);
    }
    for (auto tree = leaving.rbegin(); tree != leaving.rend(); ++tree)
        drop(*tree);
    countMemory();
}

void InterestZone::drop(std::uint32_t tree)
{
    for (const auto& extraction : _extractions)
        if (extraction) extraction->detach(tree);
    _loaded.erase(tree);
}

void InterestZone::load(std::uint32_t tree, std::uint32_t fragments)
{
    const MtEntry& entry = _file.info().trees[tree];
    const auto parent = _loaded.find(entry.parent);
    auto read = parent == _loaded.end()
                    ? foundation::Error{_file.path().string(), "its parent is damaged", ""}
                    : _file.read(tree, parent->second.get(), fragments);
    ++_reads;
    _readBytes += entry.bytes;
    if (_settings.mostBytesPerS < std::numeric_limits<double>::infinity())
        std::this_thread::sleep_for(std::chrono::duration<double>(entry.bytes / _settings.mostBytesPerS));
    if (!read)
    {
        _isDamaged[tree] = true;
        _faults.push_back(read.error().message());
        return;
    }
    const auto [loaded, isNew] = _loaded.emplace(tree, std::make_unique<ReadTree>(std::move(*read)));
    for (const auto& extraction : _extractions)
        if (extraction) extraction->attach(tree, loaded->second->tree);
    countMemory();
}

void InterestZone::countMemory()
{
    _memory = 0;
    for (const auto& [tree, read] : _loaded)
        _memory += bytesOf(_file.info().trees[tree], read->tree.part.fragments.size(), views());
}

} // namespace osgMultiTriangulation::core
