// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/extract/Extraction.h>
#include <osgMultiTriangulation/core/file/MtFile.h>
#include <osgMultiTriangulation/core/zone/TreeIndex.h>

namespace osgMultiTriangulation::core
{

/// Which trees are wanted around the eye. Distances are on the lattice.
struct ZoneSettings
{
    double completeWithin = 0.0; ///< trees that are nearer are loaded completely
    double nothingBeyond =
        0.0; ///< trees that are farther, not at all; between the two the level falls evenly
    std::size_t memoryBytes = 0; ///< that trees may take
    double hysteresis =
        0.25; ///< a tree stays as it is while its level is within this share of the wanted one
};

/// Keeps the trees of a file in memory that are wanted around a moving eye, and an extraction over them.
/// A tree whose child is wanted is wanted completely. The nearest trees have the memory first; what does not fit is not loaded.
/// Reading happens in moveTo(), in the calling thread. A damaged tree is told once and then left out: the surface is coarser there.
/// Source: *Multi-Triangulation as applied to very large terrains visualization* (Graphicon 2005), sections 4 and 5. Differs: a tree
/// is read anew when its level changes.
/// Threads: one.
class InterestZone
{
public:
    /// `file`: must live as long as the zone. Errors: the main part is damaged, or does not fit the memory.
    static foundation::Result<std::unique_ptr<InterestZone>> open(const MtFile& file,
                                                                  const ZoneSettings& settings);

    /// Drops, loads and changes trees for an eye at a place on the lattice.
    void moveTo(double x, double y);

    Extraction& extraction() { return *_extraction; }

    std::size_t memoryBytes() const { return _memory; }
    std::size_t loadedTrees() const { return _loaded.size(); }
    std::uint64_t reads() const { return _reads; }
    const std::vector<std::string>& faults() const { return _faults; }

    /// Returns the memory that a tree with so many fragments is counted with, which is no less than it takes.
    static std::size_t bytesOf(const MtEntry& tree, std::size_t fragments);

private:
    struct Loaded
    {
        ReadTree read;
        std::size_t bytes = 0;
    };
    using Wanted = std::map<std::uint32_t, std::uint32_t>; ///< fragments by tree

    InterestZone(const MtFile& file, const ZoneSettings& settings)
        : _file(file), _settings(settings), _index(file.info().trees)
    {
    }

    Wanted wantedAt(double x, double y) const;
    bool isNearEnough(std::uint32_t tree, std::uint32_t wanted) const;
    void drop(std::uint32_t tree);
    void load(std::uint32_t tree, std::uint32_t fragments);

    const MtFile& _file;
    ZoneSettings _settings;
    TreeIndex _index;
    std::map<std::uint32_t, std::unique_ptr<Loaded>> _loaded;
    std::unique_ptr<Extraction> _extraction;
    std::vector<bool> _isDamaged;
    std::vector<std::string> _faults;
    std::size_t _memory = 0;
    std::uint64_t _reads = 0;
};

} // namespace osgMultiTriangulation::core
