// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <istream>
#include <memory>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osgPMObjects/core/progressive/ProgressiveMesh.h>

namespace osgPMObjects::core
{

/// An image that a file carries for its materials, as the bytes of an image file.
struct PmImage
{
    std::string name;       ///< where it came from; may be empty
    std::string format;     ///< extension of such files: "png"
    bool isFlipped = false; ///< after decoding, the first row is the last one
    std::string bytes;
    bool operator==(const PmImage&) const = default;
};

/// The form of a `.pm` file; docs/reference/pm-file.md describes the format.
/// Invariant: checkSettings().
struct PmSettings
{
    static constexpr std::uint32_t kMostStepSections = 32;

    /// True stores positions in 16 bits an axis of the mesh's box, normals in 2 × 16 bits (octahedral),
    /// texture coordinates in 16 bits of their range, colours in 8 bits. False stores doubles and floats
    /// unchanged.
    bool quantised = false;
    /// Number of sections of steps, 1 … kMostStepSections. A reader may stop after any section; each doubles
    /// the steps.
    std::uint32_t stepSections = 8;
    /// Bytes that the file carries with the materials; readers get them with the coarsest level.
    std::string attachment;
    /// Images of the materials, which lie behind the coarsest level: each before the first section of steps
    /// that is larger.
    std::vector<PmImage> images;
};

/// Tells whether a file can be written by these settings: else an error that names the field.
foundation::Outcome checkSettings(const PmSettings& settings);

/// Returns the bytes of a `.pm` file. The mesh must satisfy isValid(), the settings checkSettings().
std::string pmBytes(const ProgressiveMesh& progressive, const PmSettings& settings = {});

/// Writes a whole file, or none. Errors: those of checkSettings() and of foundation::writeWholeFile().
foundation::Outcome writePm(const std::filesystem::path& file, const ProgressiveMesh& progressive,
                            const PmSettings& settings = {});

/// Reads a `.pm` file section by section, from the coarsest level on. After each section mesh() returns a
/// whole progressive mesh whose level 0 is the finest level that has been read.
/// Errors name the stream and the section: no `.pm` file, a wrong check sum, a file cut off, impossible
/// contents. What was read before an error remains good.
/// Threads: one at a time. The stream must outlive the reader.
class PmReader
{
public:
    /// `place`: name of the stream in errors.
    PmReader(std::istream& stream, std::string place);
    ~PmReader();
    PmReader(PmReader&&) noexcept;
    PmReader& operator=(PmReader&&) noexcept;

    /// Reads up to the next usable level. Returns false when the file has ended and the mesh is whole.
    foundation::Result<bool> readMore();

    /// Returns the mesh as far as it has been read; call readMore() at least once before.
    /// Cost: linear in the mesh; every step is checked.
    foundation::Result<ProgressiveMesh> mesh() const;

    /// Returns whether the latest error was the end of the stream: what was read before is the beginning of a
    /// sound file.
    bool isCutOff() const;

    /// Returns PmSettings::attachment; known after the first readMore().
    const std::string& attachment() const;

    /// Returns the first PmSettings::images, as many as have been read.
    const std::vector<PmImage>& images() const;

    /// Returns how many positions have been read.
    std::size_t positions() const;

    /// Return how many steps and positions the whole mesh has; known after the first readMore().
    std::uint32_t totalSteps() const;
    std::uint32_t totalPositions() const;

private:
    class Sections;
    std::unique_ptr<Sections> _sections;
};

/// Reads a whole `.pm` file. Errors: the file cannot be opened; those of PmReader.
foundation::Result<ProgressiveMesh> readPm(const std::filesystem::path& file);

} // namespace osgPMObjects::core
