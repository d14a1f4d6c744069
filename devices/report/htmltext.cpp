// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/htmltext.h"

#include "files/qttext.h"

#include <QDateTime>

#include <algorithm>
#include <cmath>

namespace mb {
namespace {

constexpr double leastPlain = 1e-4;
constexpr double mostPlain = 1e10;

} // namespace

HtmlTable::HtmlTable(QString aligns, const QStringList &heads, int width)
    : m_aligns(std::move(aligns))
    , m_width(width)
{
    if (!heads.isEmpty())
        m_head = QStringLiteral("<thead>") + row(heads, "th") + QStringLiteral("</thead>");
}

QString HtmlTable::row(const QStringList &cells, const char *tag) const
{
    QString html = QStringLiteral("<tr>");
    for (int i = 0; i < cells.size(); ++i) {
        const bool right = i < m_aligns.size() && m_aligns.at(i) == QLatin1Char('r');
        html += QStringLiteral("<%1 align=\"%2\">%3</%1>")
                    .arg(QLatin1String(tag), right ? QStringLiteral("right") : QStringLiteral("left"), cells.at(i));
    }
    return html + QStringLiteral("</tr>\n");
}

void HtmlTable::add(const QStringList &cells)
{
    m_rows += row(cells, "td");
}

QString HtmlTable::html() const
{
    return QStringLiteral("<table class=\"rows\" width=\"%1%\" cellspacing=\"0\">").arg(m_width) + m_head
        + QStringLiteral("<tbody>") + m_rows + QStringLiteral("</tbody></table>\n");
}

QString beside(const QString &left, const QString &right)
{
    return QStringLiteral("<table class=\"beside\" width=\"100%\" cellspacing=\"0\"><tr><td width=\"49%\" "
                          "valign=\"top\">%1</td><td width=\"2%\"></td><td width=\"49%\" valign=\"top\">%2</td></tr>"
                          "</table>\n")
        .arg(left, right);
}

QString escaped(const QString &text)
{
    return text.toHtmlEscaped();
}

QString escaped(std::string_view text)
{
    return qt(text).toHtmlEscaped();
}

QString heading(int level, const QString &text)
{
    return QStringLiteral("<h%1>%2</h%1>\n").arg(level).arg(escaped(text));
}

QString paragraph(const QString &html, const char *role)
{
    return QStringLiteral("<p class=\"%1\">%2</p>\n").arg(QLatin1String(role), html);
}

QString strong(const QString &html, const char *role)
{
    return QStringLiteral("<b class=\"%1\">%2</b>").arg(QLatin1String(role), html);
}

QString figure(std::optional<double> value, int digits)
{
    if (!value || !std::isfinite(*value))
        return QStringLiteral("–");
    const double size = std::abs(*value);
    QString text;
    if (size == 0.0) {
        text = QStringLiteral("0");
    } else if (size < leastPlain || size >= mostPlain) {
        text = QString::number(*value, 'g', digits);
    } else {
        const int before = static_cast<int>(std::floor(std::log10(size))) + 1;
        const bool whole = std::round(*value) == *value;
        text = QString::number(*value, 'f', whole ? 0 : std::clamp(digits - before, 0, 12));
    }
    return text.replace(QLatin1Char('-'), QChar(0x2212));
}

QString fixedFigure(std::optional<double> value, int decimals, const QString &unit)
{
    if (!value || !std::isfinite(*value))
        return figure(std::nullopt);
    QString text = QString::number(*value, 'f', decimals);
    if (text.toDouble() == 0.0)
        text.remove(QLatin1Char('-')); // what rounds to nought has no sign
    return text.replace(QLatin1Char('-'), QChar(0x2212)) + QChar(0xA0) + unit;
}

QString figure(std::optional<double> value, int digits, const QString &unit)
{
    const QString text = figure(value, digits);
    return value && std::isfinite(*value) && !unit.isEmpty() ? text + QChar(0xA0) + unit : text;
}

QString worded(const std::function<QString(const Message &)> &phrase, const Message &message)
{
    return phrase ? phrase(message) : qt(message.english());
}

QString timeText(double unixTime)
{
    return QDateTime::fromMSecsSinceEpoch(std::llround(unixTime * 1e3)).toString(QStringLiteral("yyyy-MM-dd HH:mm"));
}

} // namespace mb
