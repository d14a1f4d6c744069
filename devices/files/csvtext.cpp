// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/csvtext.h"

#include <QDateTime>

#include <cmath>

namespace mb {

std::string csvRow(const std::vector<std::string> &cells)
{
    std::string row;
    for (const std::string &cell : cells) {
        const bool plain = cell.find_first_of(",\"\r\n") == std::string::npos;
        row += plain ? "" : "\"";
        for (const char c : cell)
            row.append(c == '"' ? 2 : 1, c);
        row += plain ? "," : "\",";
    }
    row.back() = '\n';
    return row;
}

std::string csvTime(double unixTime)
{
    return QDateTime::fromMSecsSinceEpoch(std::llround(unixTime * 1e3), Qt::UTC).toString(Qt::ISODate).toStdString();
}

} // namespace mb
