// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <optional>

#include <osgOffscreen/OpenGlVersion>

namespace osgOffscreen
{

namespace
{

/// Reads "MAJOR.MINOR" from the beginning of a text.
std::optional<OpenGlVersion> versionAt(std::string_view text)
{
    OpenGlVersion version;
    const char* const end = text.data() + text.size();
    const auto major = std::from_chars(text.data(), end, version.major);
    if (major.ec != std::errc() || major.ptr == end || *major.ptr != '.') return std::nullopt;
    const auto minor = std::from_chars(major.ptr + 1, end, version.minor);
    return minor.ec == std::errc() ? std::optional(version) : std::nullopt;
}

} // namespace

foundation::Outcome checkOpenGl(std::string_view offered, bool isCore, OpenGlVersion least,
                                const std::string& place)
{
    const auto tooLittle = [&](const std::string& lack)
    {
        return foundation::Error{place,
                                 "the driver offers '" + std::string(offered) + "', " + lack +
                                     ", and OpenGL " + least.text() +
                                     " in the compatibility profile is needed",
                                 "use a driver that has it (Mesa's llvmpipe does), or another backend"};
    };
    if (offered.starts_with("OpenGL ES")) return tooLittle("which is not desktop OpenGL");
    const std::optional<OpenGlVersion> version = versionAt(offered);
    if (!version) return tooLittle("which names no version");
    if (*version < least) return tooLittle("which is too old");
    if (isCore) return tooLittle("which has the core profile alone");
    return foundation::success();
}

} // namespace osgOffscreen
