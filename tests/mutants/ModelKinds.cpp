// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "Kinds.h"
#include "PmCheckSums.h"
#include "Seeds.h"

namespace
{

InputKind modelsOf(const MutantFolders& folders, const std::string& name, seeds::Files files)
{
    return {name, std::move(files),
            [folders](const std::string& file) -> std::vector<Command>
            {
                return {folders.command("pmtool", {"info", file}),
                        folders.command("pmtool", {"consolidate", file}),
                        folders.command("pmtool", {"simplify", file, "--targets", "20"}),
                        folders.command("pmtool", {"build", file, "-o", folders.made("made.pm")})};
            }};
}

InputKind progressiveMeshes(const MutantFolders& folders, seeds::Files files)
{
    InputKind kind = modelsOf(folders, "pm", std::move(files));
    kind.repair = testsupport::renewCheckSums;
    return kind;
}

InputKind polygons(const MutantFolders& folders, seeds::Files files)
{
    return {
        "polygons", std::move(files), [folders](const std::string& file) -> std::vector<Command> {
            return {folders.command("pmtool", {"tessellate", file, "--output", folders.made("tessellated")})};
        }};
}

} // namespace

std::vector<InputKind> modelKinds(const MutantFolders& folders)
{
    using seeds::joined, seeds::realFiles;
    const auto corpus = folders.corpus();
    const auto models = folders.real("models");
    const auto waves = seeds::written(folders.scratch / "waves.obj", seeds::wavesModel());
    return {
        modelsOf(folders, "obj", joined({waves}, realFiles(models, {".obj"}))),
        modelsOf(folders, "ac", realFiles(models, {".ac"})),
        modelsOf(folders, "glb", joined({corpus / "quad.glb"}, realFiles(models, {".glb"}))),
        modelsOf(folders, "gltf", {corpus / "quad.gltf", corpus / "sparse.gltf", corpus / "meshopt.gltf"}),
        progressiveMeshes(folders, {corpus / "waves.pm", corpus / "quantised.pm", corpus / "images.pm"}),
        polygons(folders, {corpus / "faces.obj", corpus / "frame.geojson"})};
}
