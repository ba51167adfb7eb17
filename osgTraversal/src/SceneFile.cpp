// SPDX-License-Identifier: Apache-2.0
#include <osgTraversal/SceneFile>

namespace osgTraversal
{

void writeLines(osgDB::OutputStream& out, const std::vector<std::string>& lines)
{
    out.writeSize(lines.size());
    out << out.BEGIN_BRACKET << std::endl;
    for (const std::string& line : lines)
        out << line << std::endl;
    out << out.END_BRACKET << std::endl;
}

std::vector<std::string> readLines(osgDB::InputStream& in)
{
    std::vector<std::string> lines;
    const std::size_t count = in.readSize();
    in >> in.BEGIN_BRACKET;
    while (lines.size() < count && !in.getException())
        in >> lines.emplace_back();
    in >> in.END_BRACKET;
    return lines;
}

bool passOn(osgDB::InputStream& in, const foundation::Outcome& outcome)
{
    if (!outcome) in.throwException(outcome.error().message());
    return static_cast<bool>(outcome);
}

} // namespace osgTraversal
