// SPDX-License-Identifier: Apache-2.0
#include "SettingsLines.h"

#include "LineReader.h"
#include "LineWriter.h"

namespace osgPMObjects
{

namespace
{

constexpr const char* kInstanceName = "instance";

} // namespace

template<class Settings>
std::vector<std::string> linesOf(const Settings& settings)
{
    LineWriter writer;
    visitFields(settings, writer);
    return std::move(writer.lines);
}

template<class Settings>
foundation::Outcome readLines(const std::vector<std::string>& lines, Settings& settings)
{
    Settings read = settings;
    LineReader reader(lines);
    visitFields(read, reader);
    if (const std::string complaint = reader.complaint(); !complaint.empty())
        return foundation::Error{"settings in a scene file", complaint,
                                 "correct the line, or write the scene again"};
    settings = std::move(read);
    return foundation::success();
}

template std::vector<std::string> linesOf(const ProgressiveNodeSettings&);
template std::vector<std::string> linesOf(const ProgressiveFieldSettings&);
template std::vector<std::string> linesOf(const FieldKind&);
template foundation::Outcome readLines(const std::vector<std::string>&, ProgressiveNodeSettings&);
template foundation::Outcome readLines(const std::vector<std::string>&, ProgressiveFieldSettings&);
template foundation::Outcome readLines(const std::vector<std::string>&, FieldKind&);

std::string lineOf(const FieldInstance& instance)
{
    LineWriter writer;
    writer(kInstanceName, instance);
    return writer.lines.front();
}

foundation::Result<FieldInstance> instanceOf(const std::string& line)
{
    FieldInstance instance;
    LineReader reader({line});
    reader(kInstanceName, instance);
    if (const std::string complaint = reader.complaint(); !complaint.empty())
        return foundation::Error{"instance in a scene file", complaint,
                                 "correct the line, or write the scene again"};
    return instance;
}

} // namespace osgPMObjects
