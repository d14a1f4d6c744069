// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTranslator>

#include <algorithm>

namespace mb::test {

/// Words of another language, which take more room: two fifths more.
class LongWords : public QTranslator {
public:
    QString translate(const char *, const char *source, const char *, int) const override
    {
        QString text = QString::fromUtf8(source);
        const int letters
            = static_cast<int>(std::count_if(text.begin(), text.end(), [](QChar c) { return c.isLetter(); }));
        const int more = (2 * letters + 4) / 5;
        for (int i = 0; i < more; ++i) // words of four letters, so that lines can be broken
            text += i % 5 == 0 && letters > 8 ? QLatin1Char(' ') : QLatin1Char('o');
        return text;
    }
    bool isEmpty() const override { return false; }
};

} // namespace mb::test
