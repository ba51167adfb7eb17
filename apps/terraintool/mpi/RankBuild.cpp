// SPDX-License-Identifier: Apache-2.0
#include "terraintool/mpi/RankBuild.h"

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include <mpi.h>

namespace terraintool
{

namespace
{

using namespace osgMultiTriangulation::core;

constexpr int kTag = 28;
constexpr const char* kPlanned = "planned"; ///< the first message to each rank; none: there is nothing to do

void send(int rank, const std::string& bytes)
{
    MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_CHAR, rank, kTag, MPI_COMM_WORLD);
}

/// A message, and the rank that has sent it.
struct Message
{
    int rank = 0;
    std::string bytes;
};

/// Waits for a message of any rank. Sleeps meanwhile: MPI_Recv would take a core.
Message receive()
{
    MPI_Status status;
    for (int isThere = 0; !isThere;)
    {
        MPI_Iprobe(MPI_ANY_SOURCE, kTag, MPI_COMM_WORLD, &isThere, &status);
        if (!isThere) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    int size = 0;
    MPI_Get_count(&status, MPI_CHAR, &size);
    Message message{status.MPI_SOURCE, std::string(static_cast<std::size_t>(size), '\0')};
    MPI_Recv(message.bytes.data(), size, MPI_CHAR, message.rank, kTag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return message;
}

/// An answer of a rank: nothing where all is well, or the three texts of an error.
std::string answerOf(const foundation::Outcome& outcome)
{
    if (outcome) return {};
    const foundation::Error& error = outcome.error();
    return error.place + '\n' + error.what + '\n' + error.remedy;
}

foundation::Outcome outcomeOf(const std::string& answer)
{
    if (answer.empty()) return foundation::success();
    const std::size_t what = answer.find('\n') + 1, remedy = answer.find('\n', what) + 1;
    return foundation::Error{answer.substr(0, what - 1), answer.substr(what, remedy - 1 - what),
                             answer.substr(remedy)};
}

/// The ranks without a job, and the part that each of the others has.
class RankTable
{
public:
    explicit RankTable(int ranks) : _partOf(static_cast<std::size_t>(ranks), kNone) {}

    void give(const BuildFolder& folder, int rank, std::uint32_t part)
    {
        _partOf[static_cast<std::size_t>(rank)] = part;
        ++_busy;
        send(rank, std::to_string(folder.order().jobOf[part]));
    }

    std::uint32_t takeBack(int rank)
    {
        const std::uint32_t part = _partOf[static_cast<std::size_t>(rank)];
        _partOf[static_cast<std::size_t>(rank)] = kNone;
        if (part != kNone) --_busy;
        _idle.push_back(rank);
        return part;
    }

    int nextIdle()
    {
        const int rank = _idle.back();
        _idle.pop_back();
        return rank;
    }

    bool hasIdle() const { return !_idle.empty(); }
    std::size_t idle() const { return _idle.size(); }
    std::uint32_t busy() const { return _busy; }

private:
    std::vector<std::uint32_t> _partOf; ///< by rank
    std::vector<int> _idle;
    std::uint32_t _busy = 0;
};

foundation::Outcome doAlone(const BuildFolder& folder, PartSchedule& schedule, const JobProgress& progress)
{
    for (std::uint32_t part = schedule.take(); part != kNone; part = schedule.take())
    {
        if (const auto done = folder.doJob(folder.order().jobOf[part]); !done) return done;
        schedule.finish(part);
        progress(schedule.done(), schedule.all());
    }
    return foundation::success();
}

} // namespace

foundation::Outcome handOutJobs(const BuildFolder& folder, const JobProgress& progress)
{
    PartSchedule schedule = folder.schedule();
    int ranks = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    if (ranks == 1) return doAlone(folder, schedule, progress);
    for (int rank = 1; rank < ranks; ++rank)
        send(rank, kPlanned);
    RankTable table(ranks);
    foundation::Outcome outcome = foundation::success();
    while (table.busy() > 0 || table.idle() + 1 < static_cast<std::size_t>(ranks) ||
           (outcome && schedule.hasReady()))
    {
        while (outcome && table.hasIdle() && schedule.hasReady())
            table.give(folder, table.nextIdle(), schedule.take());
        const Message message = receive(); // all ranks ask once, and answer each job
        const std::uint32_t part = table.takeBack(message.rank);
        const foundation::Outcome done = outcomeOf(message.bytes);
        if (outcome && !done) outcome = done;
        if (!done || part == kNone) continue;
        schedule.finish(part);
        progress(schedule.done(), schedule.all());
    }
    dismissRanks();
    return outcome;
}

void dismissRanks()
{
    int ranks = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    for (int rank = 1; rank < ranks; ++rank)
        send(rank, "");
}

void serveRank(const std::filesystem::path& folder)
{
    if (receive().bytes.empty()) return;
    const auto jobs = BuildFolder::open(folder);
    send(0, answerOf(jobs ? foundation::success() : foundation::Outcome(jobs.error())));
    for (Message job = receive(); !job.bytes.empty(); job = receive())
        send(0, answerOf(jobs->doJob(std::stoull(job.bytes))));
}

} // namespace terraintool
