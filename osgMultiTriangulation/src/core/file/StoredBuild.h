// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <mutex>
#include <vector>

#include <osgMultiTriangulation/core/file/MtInfo.h>
#include <osgMultiTriangulation/core/split/BuildForest.h>

#include "../split/PartJobs.h"
#include "PartStore.h"

namespace osgMultiTriangulation::core
{

/// A build whose parts are kept in a folder. A part is built from what the folder has of its halves, so it
/// may be built by any thread or process that sees the folder, and again without harm.
/// Memory: 60 B a part, and in build() one part.
class StoredBuild
{
public:
    /// `mostHidden`: with more hidden points below it, a part is built with a choice of them; its errors are
    /// measured over all. Source, partition and store must stay.
    StoredBuild(const PartSource& source, const Partition& partition, const PartStore& store,
                double heightStep, std::uint64_t mostHidden);

    /// Takes what an earlier run has finished. Returns by part whether it needs no work.
    std::vector<bool> resume();

    /// Whether a part needs no work: its tree is whole, and so is what is left of it, until the part above
    /// has taken that.
    bool isDone(std::uint32_t part) const;

    /// Whether what is left of a part is whole.
    bool hasRest(std::uint32_t part) const;

    /// Builds a part. Threads: parts that do not hold each other may be built at once.
    void build(std::uint32_t part);

    /// What has gone wrong so far.
    foundation::Outcome outcome() const;

    /// Writes the file, once all parts are there.
    foundation::Outcome write(MtInfo info, const std::filesystem::path& file) const;

    ForestReport report() const;

private:
    void keep(std::uint32_t part, const StoredTree& tree);
    void note(const foundation::Outcome& outcome);
    PartHalves halvesOf(std::uint32_t part);
    void measureAgain(std::uint32_t part, BuiltPart& built);
    void thinOut(std::uint32_t part, BuiltPart& built);

    const PartSource& _source;
    const Partition& _partition;
    const PartStore& _store;
    double _heightStep;
    std::uint64_t _mostHidden;
    std::vector<MtEntry> _entries;
    std::vector<std::uint32_t> _locked;
    mutable std::mutex _mutex;
    foundation::Outcome _outcome = foundation::success();
};

} // namespace osgMultiTriangulation::core
