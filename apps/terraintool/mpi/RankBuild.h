// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/jobs/BuildFolder.h>

namespace terraintool
{

/// Told after each job: how many of all are done. What it returns does not matter.
using JobProgress = std::function<bool(std::uint32_t done, std::uint32_t all)>;

/// Rank 0: hands the jobs of a folder out to the other ranks of MPI_COMM_WORLD until all are done; does them
/// itself where there is no other. It sleeps while it waits, so one rank more than cores is right. Errors:
/// the first of any rank; then no more is handed out.
foundation::Outcome handOutJobs(const osgMultiTriangulation::core::BuildFolder& folder,
                                const JobProgress& progress);

/// Rank 0: ends the work of the others where there is no folder.
void dismissRanks();

/// Other ranks: waits for the folder of rank 0, on a disk that all see, and does jobs until there are no
/// more.
void serveRank(const std::filesystem::path& folder);

} // namespace terraintool
