// SPDX-License-Identifier: Apache-2.0
#include "SettingsLines.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <sstream>

namespace osgPMObjects
{

namespace
{

constexpr std::array kSwitches{"discrete", "blend", "alpha", "continuous", "geomorph"};
constexpr std::array kProfiles{"cross", "over"};

/// Names every field once, for writing and for reading.
template<class Settings, class Visit>
void visitFields(Settings& settings, Visit& visit)
{
    auto& selection = settings.selection;
    visit("method", selection.method);
    visit("ranges.boundariesM", selection.ranges.boundariesM);
    visit("ranges.steps", selection.ranges.steps);
    visit("overlappingRanges.boundaries", selection.overlappingRanges.boundaries);
    visit("overlappingRanges.steps", selection.overlappingRanges.steps);
    visit("areaRows.leastPx", selection.areaRows.leastPx);
    visit("areaRows.steps", selection.areaRows.steps);
    visit("referenceM", selection.referenceM);
    visit("trianglePx", selection.trianglePx);
    visit("tolerancePx", selection.tolerancePx);
    visit("leastFaces", selection.leastFaces);
    visit("weights.normal", selection.weights.normal);
    visit("weights.texCoord", selection.weights.texCoord);
    visit("weights.colour", selection.weights.colour);
    visit("band", selection.band);
    visit("continuousBand", selection.continuousBand);
    visit("alpha.fadeM", selection.alpha.fadeM);
    visit("alpha.goneM", selection.alpha.goneM);
    visit("switching.method", settings.switching.method);
    visit("switching.profile", settings.switching.profile);
    visit("switching.durationS", settings.switching.durationS);
    visit("switching.staggerS", settings.switching.staggerS);
    visit("number", settings.number);
    visit("priority.importance", settings.priority.importance);
    visit("priority.isAttended", settings.priority.isAttended);
    visit("referencePixelsPerTangent", settings.referencePixelsPerTangent);
}

class Writer
{
public:
    template<class Value>
    void operator()(const char* name, const Value& value)
    {
        _line = name;
        _separator = '=';
        put(value);
        lines.push_back(_line);
    }
    std::vector<std::string> lines;

private:
    template<class Number>
    void put(const Number& number)
    {
        char text[40];
        const auto end = std::to_chars(text, text + sizeof text, number).ptr;
        put(std::string(text, end));
    }
    void put(bool value) { put(value ? 1 : 0); }
    void put(core::SelectionMethod method) { put(std::string(core::nameOf(method))); }
    void put(core::SwitchMethod method) { put(std::string(kSwitches[static_cast<std::size_t>(method)])); }
    void put(core::BlendProfile profile) { put(std::string(kProfiles[static_cast<std::size_t>(profile)])); }
    void put(const std::string& word)
    {
        _line += _separator + word;
        _separator = ',';
    }
    void put(const core::OverlapM& boundary)
    {
        put(boundary.nearM);
        put(boundary.farM);
    }
    template<class Value>
    void put(const std::vector<Value>& values)
    {
        for (const Value& value : values)
            put(value);
    }

    std::string _line;
    char _separator = '=';
};

class Reader
{
public:
    explicit Reader(const std::vector<std::string>& lines)
    {
        for (const std::string& line : lines)
        {
            const std::size_t end = line.find('=');
            std::string& words = _values[line.substr(0, end)];
            words = end == std::string::npos ? "" : line.substr(end + 1);
            std::replace(words.begin(), words.end(), ',', ' ');
        }
    }

    template<class Value>
    void operator()(const char* name, Value& value)
    {
        const auto found = _values.find(name);
        if (found == _values.end()) return;
        std::istringstream words(found->second);
        if ((!get(words, value) || !(words >> std::ws).eof()) && wrong.empty())
            wrong = std::string(name) + " cannot be \"" + found->second + "\"";
        _values.erase(found);
    }

    /// The first value that is wrong, or name that nobody has asked for; empty: none.
    std::string complaint() const
    {
        return wrong.empty() && !_values.empty() ? "\"" + _values.begin()->first + "\" is not known" : wrong;
    }
    std::string wrong;

private:
    template<class Number>
    static bool get(std::istream& words, Number& number)
    {
        std::string word;
        words >> word;
        const auto read = std::from_chars(word.data(), word.data() + word.size(), number);
        return read.ec == std::errc() && read.ptr == word.data() + word.size();
    }
    static bool get(std::istream& words, bool& value)
    {
        int number = 0;
        if (!get(words, number)) return false;
        value = number != 0;
        return number == 0 || number == 1;
    }
    template<class Choice, class NameOf>
    static bool getChoice(std::istream& words, Choice& choice, std::size_t count, const NameOf& nameAt)
    {
        std::string word;
        words >> word;
        for (std::size_t i = 0; i < count; ++i)
            if (word == nameAt(i))
            {
                choice = static_cast<Choice>(i);
                return true;
            }
        return false;
    }
    static bool get(std::istream& words, core::SelectionMethod& method)
    {
        return getChoice(words, method, core::kSelectionMethods,
                         [](std::size_t i) { return core::nameOf(static_cast<core::SelectionMethod>(i)); });
    }
    static bool get(std::istream& words, core::SwitchMethod& method)
    {
        return getChoice(words, method, kSwitches.size(), [](std::size_t i) { return kSwitches[i]; });
    }
    static bool get(std::istream& words, core::BlendProfile& profile)
    {
        return getChoice(words, profile, kProfiles.size(), [](std::size_t i) { return kProfiles[i]; });
    }
    static bool get(std::istream& words, core::OverlapM& boundary)
    {
        return get(words, boundary.nearM) && get(words, boundary.farM);
    }
    template<class Value>
    static bool get(std::istream& words, std::vector<Value>& values)
    {
        for (values.clear(); !(words >> std::ws).eof();)
            if (!get(words, values.emplace_back())) return false;
        return true;
    }

    std::map<std::string, std::string> _values;
};

} // namespace

std::vector<std::string> linesOf(const NodeSettings& settings)
{
    Writer writer;
    visitFields(settings, writer);
    return std::move(writer.lines);
}

foundation::Result<NodeSettings> settingsOf(const std::vector<std::string>& lines)
{
    NodeSettings settings;
    Reader reader(lines);
    visitFields(settings, reader);
    const double importance = settings.priority.importance, reference = settings.referencePixelsPerTangent;
    std::string complaint = reader.complaint();
    if (complaint.empty() && (!(importance > 0.0) || !(reference >= 0.0)))
        complaint = "an importance that is not above 0, or a negative reference";
    if (complaint.empty()) return settings;
    return foundation::Error{"settings of a progressive node", complaint,
                             "correct the line, or write the scene again"};
}

} // namespace osgPMObjects
