// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/extract/Extraction.h>
#include <osgMultiTriangulation/core/file/MtFile.h>
#include <osgMultiTriangulation/core/zone/TreeIndex.h>
#include <osgMultiTriangulation/core/zone/ZoneSettings.h>

namespace osgMultiTriangulation::core
{

/// Keeps the trees of a file in memory that are wanted around moving eyes, and an extraction over them for
/// each view. A tree whose child is wanted is wanted completely. The nearest trees have the memory first;
/// what does not fit is not loaded. Reading happens in moveTo() and step(), in the calling thread. A damaged
/// section of a tree is told once and then left out, with those after it: the surface is coarser there.
/// A tree that is wanted in part is held in part. It stays as it is while it is within the threshold of what
/// is wanted, on either side; it is cut in memory, and only what is missing is read.
/// Source: *Multi-Triangulation as applied to very large terrains visualization* (Graphicon 2005), sections 4
/// and 5. Differs: levels are whole sections of a tree; where memory is short, trees keep no more than is
/// wanted.
/// Threads: one.
class InterestZone
{
public:
    /// `file`: must live as long as the zone. There is one view in the beginning, 0.
    /// Errors: the main part is damaged, or does not fit the memory.
    static foundation::Result<std::unique_ptr<InterestZone>> open(const MtFile& file,
                                                                  const ZoneSettings& settings);

    /// Drops, loads and changes trees for an eye at a place on the lattice, or for several eyes.
    void moveTo(double x, double y);
    void moveTo(std::span<const ZoneEye> eyes);

    /// Does a part of what moveTo() does: drops what has to go, then reads for one tree at most. Returns
    /// whether all is as it is wanted.
    bool step(std::span<const ZoneEye> eyes);

    /// Adds a view with an extraction of its own over the same trees, and returns its number: that of another
    /// view when the memory does not hold the main part once more. Trees far from the eyes may leave for it.
    std::size_t addView();
    void removeView(std::size_t view) { _extractions[view] = nullptr; }
    std::size_t views() const;

    Extraction& extraction(std::size_t view = 0) { return *_extractions[view]; }

    std::size_t memoryBytes() const { return _memory; }
    std::size_t loadedTrees() const { return _loaded.size(); }
    std::uint64_t reads() const { return _reads; }
    std::uint64_t readBytes() const { return _readBytes; }
    const std::vector<std::string>& faults() const { return _faults; }

    /// Returns the memory that a tree with so many fragments is counted with, which is no less than it takes.
    static std::size_t bytesOf(const MtEntry& tree, std::size_t fragments, std::size_t views = 1);

private:
    using Wanted = std::map<std::uint32_t, std::uint32_t>; ///< fragments by tree
    /// What shall be in memory, and the trees in the order in which they are loaded.
    struct Plan
    {
        Wanted wanted;
        std::vector<std::uint32_t> order;
    };

    /// The fragments that a tree needs, and those that it may keep where there is memory.
    struct Level
    {
        std::uint32_t needed = 0, kept = 0;
    };

    InterestZone(const MtFile& file, const ZoneSettings& settings);

    std::vector<std::pair<double, std::uint32_t>> inReach(std::span<const ZoneEye> eyes) const;
    Plan planFor(std::span<const ZoneEye> eyes, std::size_t views) const;
    std::uint32_t fragmentsAt(std::uint32_t tree, double distance) const;
    std::uint32_t heldFragments(std::uint32_t tree) const;
    Level levelFor(std::uint32_t tree, std::uint32_t wanted) const;
    void dropUnwanted(const Wanted& wanted);
    void drop(std::uint32_t tree);
    void truncate(std::uint32_t tree, std::uint32_t fragments);
    void load(std::uint32_t tree, std::uint32_t fragments);
    void loadMore(std::uint32_t tree, std::uint32_t fragments);
    void countRead(std::uint64_t bytes);
    void countMemory();

    const MtFile& _file;
    ZoneSettings _settings;
    TreeIndex _index;
    std::vector<float> _errors; ///< by tree: the greatest of its root's and of those of all trees below it
    float _greatestError = 0.0f;
    std::map<std::uint32_t, std::unique_ptr<ReadTree>> _loaded;
    std::vector<std::unique_ptr<Extraction>> _extractions;
    std::vector<ZoneEye> _eyes;        ///< the last
    std::vector<std::uint32_t> _sound; ///< by tree: how many fragments can be read, as far as is known
    std::vector<std::string> _faults;
    std::size_t _memory = 0;
    std::uint64_t _reads = 0, _readBytes = 0;
};

} // namespace osgMultiTriangulation::core
