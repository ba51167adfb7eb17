// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <limits>
#include <string>
#include <utility>

#include <foundation/Result.h>

namespace foundation
{

/// Checks the numbers of a settings struct against their ranges and keeps the first error. NaN and infinities
/// are in no range. Errors name the field: "settings.field: is 3; give a number from 0 to 1".
class SettingsCheck
{
public:
    /// `settings`: first part of the field's name in errors.
    explicit SettingsCheck(std::string settings) : _settings(std::move(settings)) {}

    /// Requires least ≤ value ≤ most, and a finite value.
    SettingsCheck& within(const char* field, double value, double least,
                          double most = std::numeric_limits<double>::max())
    {
        if (value >= least && value <= most)
            return *this; // no words where nothing is wrong: fields check each of their objects
        return require(false, field, "is " + text(value),
                       isLargest(most) ? "give a finite number of at least " + text(least)
                                       : "give a number from " + text(least) + " to " + text(most));
    }

    /// Requires limit < value ≤ most, and a finite value.
    SettingsCheck& above(const char* field, double value, double limit,
                         double most = std::numeric_limits<double>::max())
    {
        if (value > limit && value <= most) return *this;
        return require(false, field, "is " + text(value),
                       "give a " + std::string(isLargest(most) ? "finite " : "") + "number above " +
                           text(limit) + (isLargest(most) ? "" : ", at most " + text(most)));
    }

    /// Requires any other condition, with the words of its error.
    SettingsCheck& require(bool holds, const char* field, std::string what, std::string remedy)
    {
        if (!holds && _outcome) _outcome = Error{_settings + '.' + field, std::move(what), std::move(remedy)};
        return *this;
    }

    /// Returns success, or the error of the first requirement that did not hold.
    Outcome outcome() const { return _outcome; }

private:
    static bool isLargest(double most) { return most == std::numeric_limits<double>::max(); }

    static std::string text(double number)
    {
        char digits[32];
        std::snprintf(digits, sizeof digits, "%g", number);
        return digits;
    }

    std::string _settings;
    Outcome _outcome = success();
};

} // namespace foundation
