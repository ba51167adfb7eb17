// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/jobs/JobOrder.h>
#include <osgMultiTriangulation/core/split/BuildForest.h>
#include <osgMultiTriangulation/core/split/PartSchedule.h>
#include <osgMultiTriangulation/core/spool/SurfaceSpool.h>
#include <osgMultiTriangulation/core/surface/PlanFrame.h>

namespace osgMultiTriangulation::core
{

/// A build cut into jobs, in a folder that any number of processes share: the surface in files, a manifest,
/// and the parts that are finished. A job is one part of the partition. It needs the results of the jobs that
/// the manifest names, nothing else, and does nothing where its own result is whole; so it may be repeated,
/// and done twice at once, without harm.
/// Use: a SurfaceSpool in incoming(folder), then plan(); in any process open(), and doJob() for each job,
/// step by step; then write(). Threads, processes: any number.
class BuildFolder
{
public:
    /// Returns the folder for the files of a surface that is to be planned, empty. One plan at a time.
    static std::filesystem::path incoming(const std::filesystem::path& folder);

    /// Cuts a build into jobs. `spool`: in incoming(folder), finished; its files move. Where the folder
    /// already has the same plan, nothing changes, and jobs that are done stay done; one of another plan is
    /// replaced.
    /// `limitMb`: of each process, as in buildMtFile(); 0: none. Errors: no room, no permission; a limit that
    /// is too small.
    static foundation::Outcome plan(const SurfaceSpool& spool, const PlanFrame& frame,
                                    const ForestOptions& options, double limitMb,
                                    const std::filesystem::path& folder);

    /// Takes a folder that plan() has made. Errors: there is none; its files are damaged.
    static foundation::Result<BuildFolder> open(const std::filesystem::path& folder);

    BuildFolder(BuildFolder&&) noexcept;
    ~BuildFolder();

    const JobOrder& order() const;
    std::uint64_t points() const;    ///< of the surface
    std::uint64_t triangles() const; ///< of the surface

    /// Returns a schedule of the parts that have still to be built, order().jobOf[part] being the job of
    /// each. It must not outlive this.
    PartSchedule schedule() const;

    /// Does a job, 0 … order().partOf.size() − 1. Errors: it is none of them; one that it needs is not done;
    /// no room.
    foundation::Outcome doJob(std::uint64_t job) const;

    /// Writes the .mt file: the bytes of buildMtFile(). The folder stays. Errors: a job is not done; no room.
    foundation::Result<ForestReport> write(const std::filesystem::path& file) const;

private:
    struct Content;
    explicit BuildFolder(std::unique_ptr<Content> content);

    std::unique_ptr<Content> _content;
};

} // namespace osgMultiTriangulation::core
