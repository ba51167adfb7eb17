// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

#include <foundation/Result.h>

namespace osgPMObjects::core
{

/// Splits a `.pm` file into its sections and verifies their check sums.
class PmSectionStream
{
public:
    struct Section
    {
        std::string letters, contents;
    };

    /// `place`: name of the stream in errors.
    PmSectionStream(std::istream& stream, std::string place) : _stream(stream), _place(std::move(place)) {}

    /// Reads what precedes the first section. Errors: not a `.pm` file, or another version.
    foundation::Outcome readBegin();

    /// Reads the next section. Errors: cut off, or a wrong check sum.
    foundation::Outcome read(Section& section);
    /// Reads the contents of a section that must be the next one. Errors: those above, or another section.
    foundation::Outcome read(std::string_view letters, std::string& contents);

    /// Returns the size of the file in bytes, if the stream can tell.
    std::optional<std::uint64_t> size() const { return _size; }

    /// Returns the version of the format; known after readBegin().
    std::uint32_t version() const { return _version; }

    /// Returns whether the latest section was cut off, or missing.
    bool isCutOff() const { return _isCutOff; }

    /// Returns an error that names the current position of the stream.
    foundation::Error damaged(const std::string& what) const;

private:
    std::string take(std::uint64_t count);

    std::istream& _stream;
    std::string _place;
    std::uint64_t _at = 0;
    std::optional<std::uint64_t> _size;
    std::uint32_t _version = 0;
    bool _isCutOff = false;
};

} // namespace osgPMObjects::core
