// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <set>

#include <osgMultiTriangulation/core/zone/InterestZone.h>

namespace osgMultiTriangulation::core
{

foundation::Result<std::unique_ptr<InterestZone>> InterestZone::open(const MtFile& file,
                                                                     const ZoneSettings& settings)
{
    std::unique_ptr<InterestZone> zone(new InterestZone(file, settings));
    zone->_isDamaged.assign(file.info().trees.size(), false);
    const MtEntry& main = file.info().trees[0];
    if (bytesOf(main, main.fragments) > settings.memoryBytes)
        return foundation::Error{file.path().string(),
                                 "its main part needs " + std::to_string(bytesOf(main, main.fragments)) +
                                     " bytes",
                                 "allow more memory, or build it with more --trees"};
    auto read = file.read(0, nullptr);
    if (!read) return read.error();
    auto loaded = std::make_unique<Loaded>(Loaded{std::move(*read), bytesOf(main, main.fragments)});
    zone->_memory = loaded->bytes;
    zone->_reads = 1;
    zone->_extraction = std::make_unique<Extraction>(loaded->read.tree);
    zone->_loaded.emplace(0, std::move(loaded));
    return zone;
}

std::size_t InterestZone::bytesOf(const MtEntry& tree, std::size_t fragments)
{
    // By triangle: corners, error, two links, place in the extraction, itself in a child; by fragment: itself, its floor, its point, and
    // two triangles of the drain that are roots of children.
    const std::size_t rootPoints = tree.points - std::min(tree.points, tree.fragments);
    return 36 * (tree.rootTriangles + 6 * fragments) + 56 * fragments + 24 * rootPoints +
           8 * tree.rootTriangles;
}

/// Decides what is loaded at a place: how many fragments of each tree, the main part's always.
InterestZone::Wanted InterestZone::wantedAt(double x, double y) const
{
    const std::vector<MtEntry>& trees = _file.info().trees;
    std::vector<std::pair<double, std::uint32_t>> byDistance;
    for (const std::uint32_t t : _index.near(x, y, _settings.nothingBeyond))
        if (const double distance = distanceTo(trees[t], x, y); t != 0 && distance < _settings.nothingBeyond)
            byDistance.emplace_back(distance, t);
    std::ranges::sort(byDistance); // a parent is no farther than its children, and has a lower number
    Wanted wanted{{0, trees[0].fragments}};
    std::size_t bytes = bytesOf(trees[0], trees[0].fragments);
    for (const auto& [distance, t] : byDistance)
    {
        const auto parent = wanted.find(trees[t].parent);
        if (_isDamaged[t] || parent == wanted.end()) continue;
        const double range = std::max(_settings.nothingBeyond - _settings.completeWithin, 1e-9);
        const double level = std::min(1.0, (_settings.nothingBeyond - distance) / range);
        const auto fragments = static_cast<std::uint32_t>(std::lround(level * trees[t].fragments));
        const MtEntry& above = trees[trees[t].parent];
        const std::size_t more =
            bytesOf(trees[t], fragments) + bytesOf(above, above.fragments) - bytesOf(above, parent->second);
        if (fragments == 0 || bytes + more > _settings.memoryBytes) continue;
        parent->second = above.fragments;
        wanted[t] = fragments;
        bytes += more;
    }
    return wanted;
}

/// Whether a loaded tree may stay as it is.
bool InterestZone::isNearEnough(std::uint32_t tree, std::uint32_t wanted) const
{
    const double now = static_cast<double>(_loaded.at(tree)->read.tree.part.fragments.size());
    const std::uint32_t all = _file.info().trees[tree].fragments;
    if (wanted == all) return now == all;
    return std::abs(now - wanted) <= _settings.hysteresis * wanted && now <= wanted;
}

void InterestZone::moveTo(double x, double y)
{
    const Wanted wanted = wantedAt(x, y);
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
    for (const auto& [tree, fragments] : wanted)
        if (!_loaded.contains(tree)) load(tree, fragments);
}

void InterestZone::drop(std::uint32_t tree)
{
    _extraction->detach(tree);
    _memory -= _loaded.at(tree)->bytes;
    _loaded.erase(tree);
}

void InterestZone::load(std::uint32_t tree, std::uint32_t fragments)
{
    const MtEntry& entry = _file.info().trees[tree];
    const auto parent = _loaded.find(entry.parent);
    if (parent == _loaded.end()) return; // damaged
    auto read = _file.read(tree, &parent->second->read, fragments);
    ++_reads;
    if (!read)
    {
        _isDamaged[tree] = true;
        _faults.push_back(read.error().message());
        return;
    }
    auto loaded = std::make_unique<Loaded>(Loaded{std::move(*read), bytesOf(entry, fragments)});
    _memory += loaded->bytes;
    _extraction->attach(tree, loaded->read.tree);
    _loaded.emplace(tree, std::move(loaded));
}

} // namespace osgMultiTriangulation::core
