// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <foundation/Result.h>
#include <nlohmann/json.hpp>

namespace scenery
{

/// The first fault of a file.
struct Complaint
{
    std::string file;
    std::optional<foundation::Error> error;

    void say(const std::string& pointer, const std::string& what, const std::string& remedy)
    {
        if (!error) error = foundation::Error{file + ": " + (pointer.empty() ? "/" : pointer), what, remedy};
    }
};

/// One JSON object whose members are read one by one. A member that is never read is a fault. After the first
/// fault all members keep their default values.
class JsonFields
{
public:
    JsonFields(const nlohmann::json& object, std::string pointer, Complaint& complaint)
        : _object(object), _pointer(std::move(pointer)), _complaint(complaint)
    {
        if (!object.is_object()) _complaint.say(_pointer, "is no object", "write { … }");
    }
    ~JsonFields()
    {
        if (!_object.is_object()) return;
        for (const auto& [name, value] : _object.items())
            if (std::find(_known.begin(), _known.end(), name) == _known.end())
                _complaint.say(at(name), "is not known here", "known: " + knownNames());
    }
    JsonFields(const JsonFields&) = delete;
    JsonFields& operator=(const JsonFields&) = delete;

    std::string at(const std::string& name) const { return _pointer + "/" + name; }
    Complaint& complaint() const { return _complaint; }

    /// Returns the member, or null when it is absent.
    const nlohmann::json* find(const std::string& name)
    {
        _known.push_back(name);
        if (!_object.is_object()) return nullptr;
        const auto found = _object.find(name);
        return found == _object.end() ? nullptr : &*found;
    }

    bool number(const std::string& name, double& value, double least, double most)
    {
        const nlohmann::json* const found = find(name);
        return found && numberOf(*found, at(name), value, least, most);
    }
    template<class Whole>
    bool whole(const std::string& name, Whole& value, double least, double most)
    {
        double number = 0.0;
        if (!this->number(name, number, least, most)) return false;
        if (number != std::floor(number))
            _complaint.say(at(name), "is no whole number", "round it");
        else
            value = static_cast<Whole>(number);
        return true;
    }
    bool text(const std::string& name, std::string& value)
    {
        const nlohmann::json* const found = find(name);
        if (!found) return false;
        if (found->is_string())
            value = found->get<std::string>();
        else
            _complaint.say(at(name), "is no text", "write \"…\"");
        return true;
    }
    bool flag(const std::string& name, bool& value)
    {
        const nlohmann::json* const found = find(name);
        if (!found) return false;
        if (found->is_boolean())
            value = found->get<bool>();
        else
            _complaint.say(at(name), "is neither true nor false", "write true or false");
        return true;
    }
    bool numbers(const std::string& name, std::vector<double>& values, double least, double most)
    {
        const nlohmann::json* const found = list(name);
        for (std::size_t i = 0; found && i < found->size(); ++i)
            numberOf((*found)[i], at(name) + "/" + std::to_string(i), values.emplace_back(), least, most);
        return found != nullptr;
    }
    /// Returns a list, or null when it is absent or no list.
    const nlohmann::json* list(const std::string& name)
    {
        const nlohmann::json* const found = find(name);
        if (found && !found->is_array()) _complaint.say(at(name), "is no list", "write [ … ]");
        return found && found->is_array() ? found : nullptr;
    }
    /// Reads one of some words; the first has the value 0.
    template<class Choice, std::size_t n>
    bool choice(const std::string& name, Choice& value, const std::array<const char*, n>& words)
    {
        std::string word;
        if (!text(name, word)) return false;
        const auto found = std::find(words.begin(), words.end(), word);
        if (found != words.end())
            value = static_cast<Choice>(found - words.begin());
        else
        {
            std::string all;
            for (const char* known : words)
                all += (all.empty() ? "" : ", ") + std::string(known);
            _complaint.say(at(name), "'" + word + "' is none", "one of " + all);
        }
        return true;
    }

private:
    bool numberOf(const nlohmann::json& found, const std::string& place, double& value, double least,
                  double most)
    {
        const double read = found.is_number() ? found.get<double>() : std::nan("");
        if (read >= least && read <= most)
            value = read;
        else
            _complaint.say(place, found.is_number() ? "is out of range" : "is no number",
                           "give one from " + shortText(least) + " to " + shortText(most));
        return true;
    }
    static std::string shortText(double value)
    {
        std::string text = std::to_string(value);
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') text.pop_back();
        return text;
    }
    std::string knownNames() const
    {
        std::string all;
        for (const std::string& name : _known)
            all += (all.empty() ? "" : ", ") + name;
        return all;
    }

    const nlohmann::json& _object;
    std::string _pointer;
    Complaint& _complaint;
    std::vector<std::string> _known;
};

} // namespace scenery
