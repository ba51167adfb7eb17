// SPDX-License-Identifier: Apache-2.0
#include "ProgramRun.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <thread>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "RasterWriter.h"

namespace
{

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double kSlowness = 5.0;
#else
constexpr double kSlowness = 1.0;
#endif

/// Becomes the command, with its words going to files; never comes back.
[[noreturn]] void become(const std::vector<std::string>& command, const TemporaryFolder& folder)
{
    std::vector<char*> arguments;
    for (const std::string& argument : command)
        arguments.push_back(
            const_cast<char*>(argument.c_str())); // execvp's old signature; it changes nothing
    arguments.push_back(nullptr);
    setpgid(0, 0);
    const int words[] = {open("/dev/null", O_RDONLY),
                         open((folder / "out").c_str(), O_WRONLY | O_CREAT, 0600),
                         open((folder / "err").c_str(), O_WRONLY | O_CREAT, 0600)};
    for (int stream = 0; stream < 3; ++stream)
        dup2(words[stream], stream);
    execvp(arguments.front(), arguments.data());
    _exit(127);
}

} // namespace

std::string ProgramRun::text() const
{
    return "exit code " + std::to_string(exitCode) + (timedOut ? " (killed: out of time)" : "") +
           "\nstdout:\n" + output + "\nstderr:\n" + errors;
}

ProgramRun runProgram(const std::vector<std::string>& command, double limitS)
{
    using Clock = std::chrono::steady_clock;
    const TemporaryFolder folder;
    const auto end = Clock::now() + std::chrono::duration<double>(limitS * kSlowness);
    const pid_t child = fork();
    if (child == 0) become(command, folder);
    ProgramRun run;
    int status = 0;
    while (waitpid(child, &status, WNOHANG) == 0)
    {
        if (!run.timedOut && Clock::now() > end)
        {
            run.timedOut = true;
            kill(-child, SIGKILL);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    run.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    run.output = readBytes(folder / "out");
    run.errors = readBytes(folder / "err");
    return run;
}

std::vector<std::string> withoutWorld(std::vector<std::string> arguments)
{
    const bool mayHaveOne =
        !arguments.empty() && (arguments.front() == "tour" || arguments.front() == "fly") &&
        std::find(arguments.begin(), arguments.end(), "--world-folder") == arguments.end();
    if (mayHaveOne) arguments.insert(arguments.begin() + 1, "--no-world");
    return arguments;
}

ProgramRun runTrainer(std::vector<std::string> arguments)
{
    arguments = withoutWorld(std::move(arguments));
    arguments.insert(arguments.begin(), OSGTRAINER_TRAINER);
    return runProgram(arguments);
}

ProgramRun runTerrainTool(std::vector<std::string> arguments)
{
    arguments.insert(arguments.begin(), OSGTRAINER_TERRAINTOOL);
    return runProgram(arguments);
}

std::vector<std::string> linesOf(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

testing::AssertionResult succeeds(const ProgramRun& run)
{
    if (run.exitCode == 0 && !run.timedOut) return testing::AssertionSuccess();
    return testing::AssertionFailure() << run.text();
}

testing::AssertionResult failsWith(const ProgramRun& run, int exitCode, const std::string& program,
                                   const std::vector<std::string>& words)
{
    const auto no = [&](const std::string& why) {
        return testing::AssertionFailure() << why << "\n" << run.text();
    };
    if (run.exitCode != exitCode || run.timedOut) return no("not exit code " + std::to_string(exitCode));
    const std::vector<std::string> lines = linesOf(run.errors);
    if (lines.size() != 1) return no("not one line on stderr");
    const std::string& line = lines.front();
    if (!line.starts_with(program + ": ")) return no("the line does not begin with the program's name");
    const std::string rest = line.substr(program.size() + 2);
    const std::size_t what = rest.find(": "), remedy = rest.rfind("; ");
    if (what == 0 || what == std::string::npos) return no("the line names no place");
    if (remedy == std::string::npos || remedy + 2 >= rest.size() || remedy < what)
        return no("the line names no remedy");
    for (const std::string& word : words)
        if (line.find(word) == std::string::npos) return no("'" + word + "' is not in the line");
    return testing::AssertionSuccess();
}
