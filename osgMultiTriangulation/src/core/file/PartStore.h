// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/file/MtFile.h>

#include "../split/PartJobs.h"

namespace osgMultiTriangulation::core
{

/// A part's tree as it is kept until the file is written.
struct StoredTree
{
    EncodedTree encoded;
    std::uint32_t locked = 0; ///< points on its border
};

/// A folder with the finished parts of a build. Each is a file of its own that is whole or not there; a damaged one is not there
/// either. Files that another machine wrote may be read only where bytes have the same order.
class PartStore
{
public:
    /// Opens or makes the folder, and empties it when it is of another build. `identity`: of input and options.
    static foundation::Result<PartStore> open(const std::filesystem::path& folder, std::uint32_t identity);

    foundation::Outcome putTree(std::uint32_t part, const StoredTree& tree) const;
    foundation::Outcome putRest(std::uint32_t part, const PartMesh& rest) const;
    std::optional<StoredTree> tree(std::uint32_t part) const;
    std::optional<PartMesh> rest(std::uint32_t part) const;
    void dropRest(std::uint32_t part) const;

    /// Removes the folder.
    void remove() const;

private:
    std::filesystem::path nameOf(std::uint32_t part, const char* kind) const;
    foundation::Outcome put(const std::filesystem::path& file, std::string bytes) const;
    std::optional<std::string> get(const std::filesystem::path& file) const;

    std::filesystem::path _folder;
};

} // namespace osgMultiTriangulation::core
