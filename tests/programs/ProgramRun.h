// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

/// What a program that ran as a child process left: its exit code and its words.
struct ProgramRun
{
    int exitCode = -1; ///< 128 + signal when one ended it
    bool timedOut = false;
    std::string output; ///< stdout
    std::string errors; ///< stderr

    /// Everything, for a message.
    std::string text() const;
};

/// Runs a command (a path, or a name in PATH) to its end, or for `limitS` seconds and then kills it.
ProgramRun runProgram(const std::vector<std::string>& command, double limitS = 300.0);

/// The arguments of the trainer with --no-world behind `tour` and `fly`, so that no test makes or opens a
/// world by the way. With --world-folder they stay as they are.
std::vector<std::string> withoutWorld(std::vector<std::string> arguments);

/// Runs the trainer, withoutWorld().
ProgramRun runTrainer(std::vector<std::string> arguments);
ProgramRun runTerrainTool(std::vector<std::string> arguments);

std::vector<std::string> linesOf(const std::string& text);

/// The program did all of it.
testing::AssertionResult succeeds(const ProgramRun& run);

/// The program ended with `exitCode` and one line on stderr, "PROGRAM: place: what; remedy", that has every
/// word of `words` in it.
testing::AssertionResult failsWith(const ProgramRun& run, int exitCode, const std::string& program,
                                   const std::vector<std::string>& words);
