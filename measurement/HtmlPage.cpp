// SPDX-License-Identifier: Apache-2.0
#include "measurement/HtmlPage.h"

#include <cstdio>

#include "measurement/SvgPlot.h"

namespace measurement
{

namespace
{

const char* const kStyle = R"(<style>
body { font: 16px/1.5 system-ui, sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; color: #1b2733; background: #fff }
h1 { font-size: 1.6rem } h2 { font-size: 1.15rem; margin-top: 2rem }
table { border-collapse: collapse } td, th { padding: .2rem .8rem .2rem 0; text-align: left; vertical-align: top }
td.number, th.number { text-align: right; font-variant-numeric: tabular-nums }
tr + tr td { border-top: 1px solid #dde3e8 }
img, video, svg { width: 100%; height: auto; margin: .5rem 0 }
svg text { font: 11px system-ui, sans-serif; fill: #44525e } svg g text { fill: inherit }
svg .grid { stroke: #dde3e8; stroke-width: 1 } svg polyline { stroke-width: 1.4; stroke-linejoin: round }
</style>
)";

} // namespace

std::string htmlPage(const std::string& title, const std::string& body)
{
    const std::string text = escapedMarkup(title);
    return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width\">\n<title>" +
           text + "</title>\n" + kStyle + "</head>\n<body>\n<h1>" + text + "</h1>\n" + body +
           "</body>\n</html>\n";
}

std::string figureText(double value)
{
    char text[48];
    std::snprintf(text, sizeof text, value < 1000.0 ? "%.4g" : "%.0f", value);
    return text;
}

} // namespace measurement
