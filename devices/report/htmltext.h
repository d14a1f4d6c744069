// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/message.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <functional>
#include <optional>

namespace mb {

/// Whose words a report is made of.
struct ReportText {
    Q_DECLARE_TR_FUNCTIONS(mb::ReportText)
};

/// A table of HTML, row by row. Cells are HTML already: escaped() what is not.
class HtmlTable {
public:
    /// `aligns`: a letter a column, l or r. Without heads there is no head row.
    HtmlTable(QString aligns, const QStringList &heads, int width = 100);

    void add(const QStringList &cells);
    [[nodiscard]] bool isEmpty() const { return m_rows.isEmpty(); }
    [[nodiscard]] QString html() const;

private:
    [[nodiscard]] QString row(const QStringList &cells, const char *tag) const;

    QString m_aligns;
    QString m_head;
    QString m_rows;
    int m_width; ///< per cent
};

/// Two blocks beside each other.
[[nodiscard]] QString beside(const QString &left, const QString &right);

/// In the words of `phrase`, as in Report; without one in English.
[[nodiscard]] QString worded(const std::function<QString(const Message &)> &phrase, const Message &message);
[[nodiscard]] QString escaped(const QString &text);
[[nodiscard]] QString escaped(std::string_view text);
[[nodiscard]] QString heading(int level, const QString &text);
/// `role`: a class of the style sheet, such as dim, ok, caution, danger.
[[nodiscard]] QString paragraph(const QString &html, const char *role = "");
[[nodiscard]] QString strong(const QString &html, const char *role = "");

/// So many significant digits, no exponent between 1e-4 and 1e10, a real minus: "0.003464"; "–" for what is not known.
[[nodiscard]] QString figure(std::optional<double> value, int digits = 4);
/// The same with its unit behind it.
[[nodiscard]] QString figure(std::optional<double> value, int digits, const QString &unit);
/// So many decimals, with its unit: "2.3 %".
[[nodiscard]] QString fixedFigure(std::optional<double> value, int decimals, const QString &unit);
/// "2026-11-22 13:45", in the local time of who reads it.
[[nodiscard]] QString timeText(double unixTime);

} // namespace mb
