// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace islandgen
{

/// Does what the command line of generate_terrain says: makes a terrain and, when asked, a course of roads on
/// it. VERSION is what
/// --version prints. Returns the exit code: 0, 1 where a file cannot be written or a hash differs, 2 for a
/// wrong option.
int runCommand(int argc, char** argv, const char* version);

} // namespace islandgen
