// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <istream>
#include <memory>
#include <string>

#include <foundation/Result.h>

#include <osgPMObjects/core/progressive/ProgressiveMesh.h>

namespace osgPMObjects::core
{

/// How a `.pm` file is written. docs/reference/pm-file.md has its layout.
struct PmSettings
{
    /// Positions in 16 bits an axis of the mesh's box, normals in 2 × 16 on the octahedron, texture coordinates in 16 of their range,
    /// colours in 8. Otherwise doubles and floats as they are.
    bool quantised = false;
    /// Sections of steps, at least one: each ends at a level that a reader may stop at, and doubles the steps.
    std::uint32_t stepSections = 8;
    /// Anything that belongs to the materials and is not known here, textures for instance. Readers get it with the coarsest level.
    std::string attachment;
};

/// The bytes of a `.pm` file. The mesh has to be valid (isValid()).
std::string pmBytes(const ProgressiveMesh& progressive, const PmSettings& settings = {});

/// Writes a whole file, or none. Errors: as foundation::writeWholeFile().
foundation::Outcome writePm(const std::filesystem::path& file, const ProgressiveMesh& progressive,
                            const PmSettings& settings = {});

/// Reads a `.pm` file section by section, from the coarsest level on. After each there is a whole progressive mesh, whose finest level is
/// what has been read so far; its level 0 is that one.
/// Errors: what is no such file, is damaged (each section has a check sum) or cut off, has impossible contents; with place and
/// section. What was read before an error remains good.
/// Threads: one. The stream has to outlive it.
class PmReader
{
public:
    /// `place`: the stream's name in errors.
    PmReader(std::istream& stream, std::string place);
    ~PmReader();
    PmReader(PmReader&&) noexcept;
    PmReader& operator=(PmReader&&) noexcept;

    /// Reads up to the next level that can be used; false: there is no more, the mesh is whole.
    foundation::Result<bool> readMore();

    /// The mesh as far as it has been read; of no use before the first readMore().
    /// Cost: linear in it; every step is checked.
    foundation::Result<ProgressiveMesh> mesh() const;

    /// What was attached to the materials, known after the first readMore().
    const std::string& attachment() const;

    /// How many steps the whole mesh has, and positions, known after the first readMore().
    std::uint32_t stepsInAll() const;
    std::uint32_t positionsInAll() const;

private:
    class Sections;
    std::unique_ptr<Sections> _sections;
};

/// Reads a whole `.pm` file. Errors: it cannot be opened; as PmReader.
foundation::Result<ProgressiveMesh> readPm(const std::filesystem::path& file);

} // namespace osgPMObjects::core
