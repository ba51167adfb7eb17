// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <osgMultiTriangulation/core/structure/TreeRecord.h>

namespace osgMultiTriangulation::core
{

/// Returns the greatest power of two, 1 to 2^-20, of which all heights are multiples that fit in 30 bits; 0:
/// there is none.
double commonHeightStep(std::span<const SurfacePoint> points);

/// How many fragments a section of a tree's bytes has; the last of them has what is left.
constexpr std::uint32_t kSectionFragments = 128;

/// A part of the bytes of a tree that can be read and checked by itself, once those before it are there: the
/// root; fragments; the ties to the trees below.
struct TreeSection
{
    std::uint32_t bytes = 0;
    std::uint32_t checksum = 0; ///< CRC-32
};

/// The number of sections of a tree with so many fragments: the root, the fragments, the ties.
constexpr std::uint32_t sectionsFor(std::uint32_t fragments)
{
    return 2 + fragments / kSectionFragments + (fragments % kSectionFragments == 0 ? 0 : 1);
}

/// The most fragments up to `most` that are whole sections of a tree with `fragments`.
constexpr std::size_t wholeSections(std::size_t fragments, std::size_t most)
{
    return most >= fragments ? fragments : most - most % kSectionFragments;
}

/// The bytes of the table of the sections of a tree, which its bytes begin with.
constexpr std::size_t sectionTableBytes(std::uint32_t fragments)
{
    return 4 + std::size_t{8} * sectionsFor(fragments);
}

/// Reads the table that the bytes of a tree begin with. Returns nothing when it does not fit them.
/// `bytes`: of the table; there may be more. `whole`: how many bytes the tree has.
std::optional<std::vector<TreeSection>> readSectionTable(std::span<const std::byte> bytes, std::size_t whole);

/// Returns a tree as bytes; docs/reference/mt-file.md describes them. `heightStep`: as above, of all points
/// of the file.
std::vector<std::byte> encodeTree(const TreeRecord& record, double heightStep);

/// Reads what encodeTree() wrote; nothing when the bytes are no tree. Stars follow from floors, so whatever
/// is returned keeps the invariant of MultiTriangulation. It does not look at the sections' checksums.
/// `fragments`: at most so many are read, in whole sections; the rest is left out, and with it childRoots.
std::optional<TreeRecord> decodeTree(std::span<const std::byte> bytes, double heightStep,
                                     std::size_t fragments = std::numeric_limits<std::size_t>::max());

/// The same for a tree of a file of version 1, which has no sections: the same bytes without the table.
std::optional<TreeRecord> decodeWholeTree(std::span<const std::byte> bytes, double heightStep,
                                          std::size_t fragments = std::numeric_limits<std::size_t>::max());

/// Reads the first section. `fragments`: becomes the number of all that the tree has. Returns whether the
/// bytes are a root.
bool decodeRoot(std::span<const std::byte> bytes, double heightStep, MultiTriangulation& tree,
                std::uint32_t& fragments);

/// Adds the next fragments to a tree. `bytes`: of one section, which has `count` of them. Returns whether
/// they fit; else the tree is as it was.
bool decodeFragments(std::span<const std::byte> bytes, double heightStep, std::uint32_t count,
                     MultiTriangulation& tree);

/// Adds the ties of a complete tree to those below it. Returns whether the bytes, the last section, are such;
/// else there are none.
bool decodeTies(std::span<const std::byte> bytes, TreeRecord& record);

/// Gives a tree the room that it needs with so many fragments, so that it takes no more.
void reserveFragments(MultiTriangulation& tree, std::size_t fragments);

} // namespace osgMultiTriangulation::core
