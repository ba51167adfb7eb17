// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/file/MtInfo.h>
#include <osgMultiTriangulation/core/file/TreeCode.h>
#include <osgMultiTriangulation/core/structure/Forest.h>

namespace osgMultiTriangulation::core
{

/// A tree that was read, with its ties to those below it.
struct ReadTree
{
    ForestTree tree;
    std::vector<std::vector<std::uint32_t>> childRoots; ///< by child, in the order of their numbers
    std::uint64_t readBytes = 0;                        ///< that were read for it so far
};

/// A file of a split multi-triangulation (.mt), read tree by tree. docs/reference/mt-file.md describes it.
/// Threads: any number may read at once.
class MtFile
{
public:
    /// Reads the header and the directory. Errors: no such file, not a .mt file, another version, damaged
    /// header or directory.
    static foundation::Result<MtFile> open(const std::filesystem::path& file);

    const MtInfo& info() const { return _info; }
    const std::filesystem::path& path() const { return _file; }

    /// The children of a tree, in the order of their numbers.
    std::span<const std::uint32_t> childrenOf(std::uint32_t tree) const { return _children[tree]; }

    /// The version of the file's form. Trees of version 1 have no sections: each is read as a whole.
    std::uint32_t version() const { return _version; }

    /// Reads a tree. `parent`: its parent, completely read; null for the main part. `fragments`: at most so
    /// many, in whole sections (TreeCode.h); nothing else is read.
    /// Errors: truncated, damaged, does not fit its parent; each names the tree. The other trees stay usable.
    foundation::Result<ReadTree> read(std::uint32_t tree, const ReadTree* parent,
                                      std::size_t fragments = std::numeric_limits<std::size_t>::max()) const;

    /// Reads more sections of a tree of which some were read, up to `fragments`; what is there stays as it
    /// is.
    /// Errors: as above; the sections before the damage are there then.
    foundation::Outcome readMore(std::uint32_t tree, ReadTree& read, std::size_t fragments) const;

    /// Counts the fragments before the first damaged section of a tree, by the checksums alone.
    std::uint32_t soundFragments(std::uint32_t tree) const;

private:
    foundation::Error failure(const std::string& what) const;
    foundation::Outcome readDirectory(std::span<const char> header);
    foundation::Outcome readReference(std::istream& stream);
    foundation::Result<std::vector<std::byte>> bytesAt(std::uint32_t tree, std::uint64_t offset,
                                                       std::size_t count) const;
    foundation::Result<std::vector<TreeSection>> sectionsOf(std::uint32_t tree) const;
    foundation::Outcome readSections(std::uint32_t tree, ReadTree& read, std::size_t fragments) const;
    foundation::Outcome readWhole(std::uint32_t tree, ReadTree& read, std::size_t fragments) const;
    foundation::Outcome tieToParent(std::uint32_t tree, const ReadTree* parent, ReadTree& read) const;

    std::filesystem::path _file;
    std::uint32_t _version = 0;
    MtInfo _info;
    std::vector<std::vector<std::uint32_t>> _children;
};

/// A tree as bytes, with what the directory says of it but its place.
struct EncodedTree
{
    MtEntry entry;
    std::vector<std::byte> bytes;
};

EncodedTree encodedTree(const TreeRecord& record, std::uint32_t parent, double heightStep);

/// Writes a file from encoded trees, one at a time. It appears under its name when it is complete.
/// `info`: frame, heightStep, points and triangles; its trees are replaced. `entries`: by tree. `bytesOf`:
/// the bytes of a tree, asked for once each, in order. Errors: no such folder, no permission, no room; what
/// `bytesOf` returns.
foundation::Outcome
writeMtFile(const std::filesystem::path& file, const MtInfo& info, std::vector<MtEntry> entries,
            const std::function<foundation::Result<std::vector<std::byte>>(std::uint32_t)>& bytesOf);

} // namespace osgMultiTriangulation::core
