// SPDX-License-Identifier: Apache-2.0
#include "GrassNulls.h"

#include <cctype>
#include <cstring>
#include <memory>

#include <cpl_vsi.h>

namespace osgTerrainROAM::core
{

namespace
{

struct FileCloser
{
    void operator()(VSILFILE* file) const { VSIFCloseL(file); }
};

/// Counts the words of a GRASS grid byte by byte, without header lines: those that begin with a letter.
class WordCounter
{
public:
    void take(char c)
    {
        if (c == '\n' || c == '\r')
        {
            endWord();
            _lineIsHeader = false;
            _lineIsEmpty = true;
            return;
        }
        if (std::isspace(static_cast<unsigned char>(c)))
        {
            endWord();
            return;
        }
        if (_lineIsEmpty && std::isalpha(static_cast<unsigned char>(c))) _lineIsHeader = true;
        _lineIsEmpty = false;
        if (_lineIsHeader) return;
        _isStar = !_inWord && c == '*';
        _inWord = true;
    }

    void endWord()
    {
        if (!_inWord) return;
        if (_isStar) nulls.push_back(words);
        ++words;
        _inWord = _isStar = false;
    }

    std::size_t words = 0;
    std::vector<std::size_t> nulls;

private:
    bool _lineIsHeader = false;
    bool _lineIsEmpty = true;
    bool _inWord = false;
    bool _isStar = false;
};

} // namespace

foundation::Result<std::vector<std::size_t>> grassNulls(const std::string& gdalPath, std::size_t expected)
{
    const std::unique_ptr<VSILFILE, FileCloser> file(VSIFOpenL(gdalPath.c_str(), "rb"));
    if (!file) return foundation::Error{gdalPath, "cannot be opened for reading", "check its permissions"};
    WordCounter counter;
    std::vector<char> buffer(1 << 16);
    while (const std::size_t got = VSIFReadL(buffer.data(), 1, buffer.size(), file.get()))
        for (std::size_t i = 0; i < got; ++i)
            counter.take(buffer[i]);
    counter.endWord();
    if (counter.words < expected)
        return foundation::Error{gdalPath,
                                 "ends after " + std::to_string(counter.words) + " of " +
                                     std::to_string(expected) + " values",
                                 "fetch it again: it is truncated"};
    return std::move(counter.nulls);
}

} // namespace osgTerrainROAM::core
