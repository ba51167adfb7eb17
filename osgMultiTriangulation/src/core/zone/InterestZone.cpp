// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>
#include <thread>

#include <osgMultiTriangulation/core/structure/KeepFragments.h>
#include <osgMultiTriangulation/core/zone/InterestZone.h>

namespace osgMultiTriangulation::core
{

InterestZone::InterestZone(const MtFile& file, const ZoneSettings& settings)
    : _file(file), _settings(settings), _index(file.info().trees)
{
    const std::vector<MtEntry>& trees = file.info().trees;
    for (const MtEntry& tree : trees)
    {
        _sound.push_back(tree.fragments);
        _errors.push_back(tree.rootError);
    }
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
    zone->_readBytes = read->readBytes;
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

/// How many fragments of a tree are wanted at a distance.
std::uint32_t InterestZone::fragmentsAt(std::uint32_t tree, double distance) const
{
    const double range = std::max(_settings.nothingBeyond - _settings.completeWithin, 1e-9);
    const double level = std::min(1.0, (_settings.nothingBeyond - distance) / range);
    return static_cast<std::uint32_t>(std::lround(level * _file.info().trees[tree].fragments));
}

std::uint32_t InterestZone::heldFragments(std::uint32_t tree) const
{
    const auto loaded = _loaded.find(tree);
    return loaded == _loaded.end() ? 0
                                   : static_cast<std::uint32_t>(loaded->second->tree.part.fragments.size());
}

/// How many fragments a tree shall have where so many are wanted: those that it has, while they are within
/// the threshold on either side, else whole sections. All are exact.
InterestZone::Level InterestZone::levelFor(std::uint32_t tree, std::uint32_t wanted) const
{
    const std::uint32_t all = _file.info().trees[tree].fragments, now = heldFragments(tree);
    const auto whole =
        static_cast<std::uint32_t>(wholeSections(all, std::size_t{wanted} + kSectionFragments - 1));
    const std::uint32_t exact = std::min(whole, _sound[tree]);
    const bool isNear =
        now > 0 && wanted < all && std::abs(double(now) - wanted) <= _settings.hysteresis * wanted;
    if (!isNear) return {exact, exact};
    return {std::min(now, exact), now};
}

/// Decides what shall be in memory: how many fragments of each tree, the main part's always. Trees keep more
/// than is wanted only where all others have what they want.
InterestZone::Plan InterestZone::planFor(std::span<const ZoneEye> eyes, std::size_t views) const
{
    const std::vector<MtEntry>& trees = _file.info().trees;
    Plan plan{{{0, trees[0].fragments}}, {}};
    std::size_t bytes = bytesOf(trees[0], trees[0].fragments, views);
    const auto grow = [&](std::uint32_t tree, std::uint32_t from, std::uint32_t to)
    { return bytesOf(trees[tree], to, views) - bytesOf(trees[tree], from, views); };
    Wanted kept; // where it is more than is wanted
    for (const auto& [distance, t] : inReach(eyes))
    {
        const std::uint32_t wanted = fragmentsAt(t, distance), above = trees[t].parent;
        const auto parent = plan.wanted.find(above);
        if (wanted == 0 || parent == plan.wanted.end() || _sound[above] < trees[above].fragments) continue;
        const Level level = levelFor(t, wanted);
        const std::size_t more =
            bytesOf(trees[t], level.needed, views) + grow(above, parent->second, trees[above].fragments);
        if (level.needed == 0 || bytes + more > _settings.memoryBytes) continue;
        parent->second = trees[above].fragments;
        plan.wanted[t] = level.needed;
        plan.order.push_back(t);
        if (level.kept > level.needed) kept[t] = level.kept;
        bytes += more;
    }
    for (const auto& [t, fragments] : kept)
    {
        std::uint32_t& planned = plan.wanted.at(t);
        if (planned >= fragments || bytes + grow(t, planned, fragments) > _settings.memoryBytes) continue;
        bytes += grow(t, planned, fragments);
        planned = fragments;
    }
    return plan;
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
    {
        const std::uint32_t wanted = plan.wanted.at(tree);
        if (heldFragments(tree) >= wanted) continue;
        if (_loaded.contains(tree))
            loadMore(tree, wanted);
        else
            load(tree, wanted);
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
        if (!wanted.contains(tree)) leaving.insert(tree);
    for (auto tree = leaving.rbegin(); tree != leaving.rend(); ++tree)
        drop(*tree);
    for (const auto& [tree, fragments] : wanted)
        if (heldFragments(tree) > fragments) truncate(tree, fragments);
    countMemory();
}

void InterestZone::drop(std::uint32_t tree)
{
    for (const auto& extraction : _extractions)
        if (extraction) extraction->detach(tree);
    _loaded.erase(tree);
}

/// Cuts a tree in memory.
void InterestZone::truncate(std::uint32_t tree, std::uint32_t fragments)
{
    for (const auto& extraction : _extractions)
        if (extraction) extraction->truncate(tree, fragments);
    ReadTree& read = *_loaded.at(tree);
    keepFragments(read.tree.part, fragments);
    releaseMemory(read.tree.part);
    read.childRoots = {};
}

void InterestZone::load(std::uint32_t tree, std::uint32_t fragments)
{
    const auto parent = _loaded.find(_file.info().trees[tree].parent);
    auto read = parent == _loaded.end()
                    ? foundation::Error{_file.path().string(), "its parent is damaged", ""}
                    : _file.read(tree, parent->second.get(), fragments);
    if (!read)
    {
        countRead(0);
        const std::uint32_t sound = _file.soundFragments(tree);
        _sound[tree] = sound < fragments ? sound : 0;
        _faults.push_back(read.error().message());
        return;
    }
    countRead(read->readBytes);
    const auto [loaded, isNew] = _loaded.emplace(tree, std::make_unique<ReadTree>(std::move(*read)));
    for (const auto& extraction : _extractions)
        if (extraction) extraction->attach(tree, loaded->second->tree);
    countMemory();
}

/// Reads what is missing of a tree that is there in part.
void InterestZone::loadMore(std::uint32_t tree, std::uint32_t fragments)
{
    ReadTree& read = *_loaded.at(tree);
    const std::uint64_t before = read.readBytes;
    const auto outcome = _file.readMore(tree, read, fragments);
    countRead(read.readBytes - before);
    for (const auto& extraction : _extractions)
        if (extraction) extraction->extend(tree);
    countMemory();
    if (outcome) return;
    const std::uint32_t all = _file.info().trees[tree].fragments; // if they are there, its ties are damaged
    _sound[tree] = static_cast<std::uint32_t>(wholeSections(all, std::min(heldFragments(tree), all - 1)));
    _faults.push_back(outcome.error().message());
}

void InterestZone::countRead(std::uint64_t bytes)
{
    ++_reads;
    _readBytes += bytes;
    if (_settings.mostBytesPerS < std::numeric_limits<double>::infinity())
        std::this_thread::sleep_for(
            std::chrono::duration<double>(static_cast<double>(bytes) / _settings.mostBytesPerS));
}

void InterestZone::countMemory()
{
    _memory = 0;
    for (const auto& [tree, read] : _loaded)
        _memory += bytesOf(_file.info().trees[tree], read->tree.part.fragments.size(), views());
}

} // namespace osgMultiTriangulation::core
