// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include <osgPMObjects/ExportNode>
#include <osgPMObjects/ImportNode>

namespace pmtool
{

/// Makes names of output files: the name of the input file without its extensions; a second one of the same
/// name gets -2.
class OutputNames
{
public:
    std::string nameFor(const std::string& file);

private:
    std::map<std::string, int> _used;
};

/// Creates a folder, and those above it, unless it exists. Errors: it cannot be created, or takes no files.
foundation::Outcome makeFolder(const std::filesystem::path& folder);

/// Writes a model, with its textures inside, in a format that OSG writes to a stream, chosen by the extension
/// (.osgb, .osgt, .ive).
/// Errors: no such format, the file cannot be written; then nothing is left behind.
foundation::Outcome writeModel(const osgPMObjects::ImportedModel& model, const std::filesystem::path& file,
                               const osgPMObjects::StripMaker& strip = {});

/// Writes positions and faces as a Wavefront .obj of `v x y z` and `f a b c` lines: every digit of every
/// position, the position's number counted from 1, faces in the mesh's order.
foundation::Outcome writePlain(const osgPMObjects::core::Mesh& mesh, const std::filesystem::path& file);

/// The same with texture coordinates (set 0) and materials: `vt u v` lines, all digits, one for each wedge,
/// `usemtl N` with the material's number counted from 0, and `f a/w b/w c/w`.
foundation::Outcome writeTextured(const osgPMObjects::core::Mesh& mesh, const std::filesystem::path& file);

} // namespace pmtool
