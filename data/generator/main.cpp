// SPDX-License-Identifier: Apache-2.0
// generate_terrain: makes the default terrain and a course of roads on it. See data/README.md.
#include "Command.h"

int main(int argc, char** argv)
{
    return islandgen::runCommand(argc, argv, OSGTRAINER_VERSION);
}
