// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace measurement
{

/// Makes a page that needs no network: a title, as plain text, the style of tables and plots, and a body of
/// markup.
std::string htmlPage(const std::string& title, const std::string& body);

/// A figure with four digits that count; 1000 and more as a whole number.
std::string figureText(double value);

} // namespace measurement
