// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/file/MtFile.h>
#include <osgMultiTriangulation/core/spool/RecordFile.h>

#include "../split/PartJobs.h"

namespace osgMultiTriangulation::core
{

/// A part's tree as it is kept until the file is written.
struct StoredTree
{
    EncodedTree encoded;
    std::uint32_t locked = 0; ///< points on its border
};

/// A hidden point in a file, with the triangle of its part's rest that it lies in.
struct HiddenRecord
{
    double height = 0.0;
    std::int32_t x = 0, y = 0;
    std::uint32_t triangle = 0, unused = 0;

    SurfacePoint point() const { return {x, y, height}; }
};

/// Adds a run of records to the sum of those before it. Runs have RecordFile::kBuffered records, but the
/// last.
std::uint32_t sumOfRecords(std::span<const HiddenRecord> records, std::uint32_t before);

/// A folder with the finished parts of a build. Each is a file of its own that is whole or not there; a
/// damaged one is not there either. Files that another machine wrote may be read only where bytes have the
/// same order. Threads, processes: any number may write at once; where two write the same part, its bytes are
/// the same.
class PartStore
{
public:
    /// Opens or makes the folder, and empties it when it is of another build. `identity`: of input and
    /// options.
    static foundation::Result<PartStore> open(const std::filesystem::path& folder, std::uint32_t identity);

    /// Takes a folder that open() has made. Errors: it is not there, or of another build.
    static foundation::Result<PartStore> existing(const std::filesystem::path& folder,
                                                  std::uint32_t identity);

    foundation::Outcome putTree(std::uint32_t part, const StoredTree& tree) const;
    foundation::Outcome putRest(std::uint32_t part, const PartMesh& rest) const;
    /// Files of all hidden points of parts that have too many for memory. A file that is written is there
    /// after commitHidden(), and counts once putRest() has told its sum.
    foundation::Result<RecordFile<HiddenRecord>> createHidden(std::uint32_t part) const;
    foundation::Outcome commitHidden(std::uint32_t part) const;
    foundation::Result<RecordFile<HiddenRecord>> openHidden(std::uint32_t part) const;

    /// Whether the file of hidden points that a rest goes with is whole.
    bool isHiddenWhole(std::uint32_t part, const PartMesh& rest) const;

    std::optional<StoredTree> tree(std::uint32_t part) const;
    std::optional<PartMesh> rest(std::uint32_t part) const;
    void dropRest(std::uint32_t part) const;

    const std::filesystem::path& folder() const { return _folder; }

    /// Removes the folder.
    void remove() const;

private:
    std::filesystem::path nameOf(std::uint32_t part, const char* kind) const;
    foundation::Outcome put(const std::filesystem::path& file, std::string bytes) const;
    std::optional<std::string> get(const std::filesystem::path& file) const;

    explicit PartStore(const std::filesystem::path& folder);

    std::filesystem::path _folder;
    std::string _ending; ///< of files that this process is writing
};

} // namespace osgMultiTriangulation::core
