// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include <osgMultiTriangulation/core/spool/SurfaceSpool.h>

#include "../split/PartSource.h"
#include "ScatterFile.h"

namespace osgMultiTriangulation::core
{

/// A surface in files, with its triangles by part in one more file.
/// Memory: 8 B a part; while it is made 0.8 kB a part; for each Points 0.4 MB.
class SpoolSource : public PartSource
{
public:
    /// Reads the triangles twice: the first time tells how many each part has, and which points have
    /// triangles around them in which part. `spool` and `partition` must stay. Errors: no room on the disk.
    static foundation::Result<std::unique_ptr<SpoolSource>>
    create(const SurfaceSpool& spool, const Partition& partition, const std::filesystem::path& folder);

    /// Takes the files that create() has made in the folder of a spool, whose triangles are not needed any
    /// more.
    /// `counts`: triangles by part, from counts(). Errors: a file is missing or of another size.
    static foundation::Result<std::unique_ptr<SpoolSource>>
    open(const SurfaceSpool& spool, const Partition& partition, const std::vector<std::uint64_t>& counts);

    std::vector<std::uint64_t> counts() const { return _byPart.counts(); } ///< triangles by part

    std::unique_ptr<Points> points() const override;
    std::vector<Triangle> trianglesOf(std::uint32_t part) const override;
    foundation::Outcome outcome() const override;
    bool isChecked() const override { return false; }

private:
    SpoolSource(const SurfaceSpool& spool, const Partition& partition) : _spool(spool), _partition(partition)
    {
    }
    std::vector<std::uint64_t> countParts();
    void scatter();
    std::uint32_t holderOf(const Triangle& triangle, RecordCache<SurfacePoint>& places) const;

    const SurfaceSpool& _spool;
    const Partition& _partition;
    RecordFile<std::uint8_t> _joinedAt; ///< by point
    ScatterFile<Triangle> _byPart;
};

/// Returns a scan of the points of a spool.
PointScan scanOf(const SurfaceSpool& spool);

} // namespace osgMultiTriangulation::core
