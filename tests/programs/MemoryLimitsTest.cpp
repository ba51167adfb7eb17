// SPDX-License-Identifier: Apache-2.0
// Programs under limits of address space: they do their work, or say in one line what they lacked; nothing half-written is left.
#include <sstream>

#include "Playing.h"
#include "ProgramRun.h"
#include "Workplace.h"

namespace
{

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;
#else
constexpr bool kIsSanitized = false;
#endif

ProgramRun underLimit(int mebibytes, std::vector<std::string> command)
{
    command.insert(command.begin(),
                   {"sh", "-c", "ulimit -v " + std::to_string(mebibytes * 1024) + "; exec \"$@\"", "sh"});
    return runProgram(command);
}

/// Fails unless the program did its work, or ended with one error of memory.
void expectDoneOrTold(const ProgramRun& run, const std::string& program, const std::string& what)
{
    if (run.exitCode == 0) return;
    EXPECT_EQ(run.exitCode, 1) << what << ": " << run.text();
    std::size_t errors = 0;
    for (const std::string& line : linesOf(run.errors))
        errors += line.starts_with(program + ": ");
    EXPECT_EQ(errors, 1U) << what << ": " << run.text();
}

TEST(MemoryLimits, EveryCommandSaysWhatItLacks)
{
    if (kIsSanitized) GTEST_SKIP() << "NOT TESTED: sanitizers reserve more address space than there is";
    const Workplace place;
    std::size_t told = 0;
    const auto before = place.files();
    using Command = std::vector<std::string>;
    const Command tour = {OSGTRAINER_TRAINER,       "tour",  place.hill(), "--frames", "1", "--stats",
                          place.path("stats.json"), "--size"};
    const auto sized = [&](const char* size)
    {
        Command command = tour;
        command.push_back(size);
        return command;
    };
    for (const int limit : {330, 360, 420, 600})
        for (const auto& [program, command] : std::vector<std::pair<std::string, Command>>{
                 {"trainer", sized("64x36")},
                 {"trainer", sized("2048x2048")},
                 {"terraintool", {OSGTRAINER_TERRAINTOOL, "info", place.hill()}}})
        {
            const ProgramRun run = underLimit(limit, command);
            const bool isLoaded = run.exitCode != 127; // below that the loader cannot map the libraries
            if (isLoaded)
                expectDoneOrTold(run, program, command[1] + " under " + std::to_string(limit) + " MiB");
            told += run.exitCode == 1;
            if (run.exitCode == 0) std::filesystem::remove(place.path("stats.json"));
            EXPECT_EQ(place.files(), before) << limit;
        }
    EXPECT_GT(told, 0U) << "no limit was too small: the test shows nothing";
}

} // namespace
