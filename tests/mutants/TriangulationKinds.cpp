// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>

#include "Kinds.h"
#include "MtCheckSums.h"
#include "Seeds.h"

namespace
{

/// A report with a finding is the word of a file that is refused.
constexpr const char* kValidate = "out=$(\"$0\" validate \"$1\"); code=$?; "
                                  "case \"$out\" in *\"  \"*) echo \"report: $out\" 1>&2;; esac; exit $code";

/// Builds a file from a raster by the program itself; none where that fails.
seeds::Files builtFile(const MutantFolders& folders)
{
    const auto raster = seeds::written(folders.scratch / "hill.asc", seeds::hillGrid());
    const std::filesystem::path file = folders.scratch / "hill.mt";
    const std::string command = "'" + (folders.programs / "terraintool").string() + "' mt-build '" +
                                raster.string() + "' -o '" + file.string() + "' --trees 4 > /dev/null 2>&1";
    return std::system(command.c_str()) == 0 ? seeds::Files{file} : seeds::Files{};
}

InputKind surfaces(const MutantFolders& folders, const std::string& name, seeds::Files files)
{
    return {name, std::move(files),
            [folders](const std::string& file) -> std::vector<Command>
            {
                return {folders.command("terraintool", {"mt-build", file, "-o", folders.made("made.mt")}),
                        folders.command("terraintool", {"mt-build", file, "-o", folders.made("within.mt"),
                                                        "--memory", "100"})};
            }};
}

} // namespace

std::vector<InputKind> triangulationKinds(const MutantFolders& folders)
{
    using seeds::joined, seeds::realFiles, seeds::written;
    InputKind triangulations{"mt", builtFile(folders),
                             [folders](const std::string& file) -> std::vector<Command>
                             {
                                 const std::string program = (folders.programs / "terraintool").string();
                                 return {
                                     {"/bin/sh", "-c", kValidate, program, file},
                                     folders.command("terraintool", {"mt-fly", file, "--seconds", "0.1"})};
                             }};
    triangulations.repair = testsupport::renewMtCheckSums;
    const auto waves = written(folders.scratch / "surface.obj", seeds::wavesModel());
    const auto quad = written(folders.scratch / "quad.ply",
                              "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                              "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                              "end_header\n0 0 1\n9 0 2\n9 9 3\n0 9 2\n4 0 1 2 3\n");
    return {std::move(triangulations),
            surfaces(folders, "tin", joined({waves, quad}, realFiles(folders.real("dem"), {".terrain"}))),
            surfaces(folders, "points", {folders.corpus() / "points.xyz"})};
}
