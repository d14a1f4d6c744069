// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/helpdrawing.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QRegularExpression>

#include <iterator>
#include <utility>

namespace mb {
namespace {

/// Each of the light colours of the design stands for one of the theme's. First to marks: two themes may swap colours.
QString coloured(QString svg, const Theme &theme)
{
    const std::pair<const char *, QColor> colors[]
        = {{"#171C22", theme.text}, {"#47525E", theme.dim}, {"#7D8894", theme.outline}, {"#3D49C4", theme.accent},
            {"#8F0F22", theme.danger}, {"#FFFFFF", theme.canvas}, {"#F2F4F7", theme.window}};
    const auto mark = [](std::size_t i) { return QStringLiteral("@%1@").arg(i); };
    for (std::size_t i = 0; i < std::size(colors); ++i)
        svg.replace(QLatin1String(colors[i].first), mark(i));
    for (std::size_t i = 0; i < std::size(colors); ++i)
        svg.replace(mark(i), colors[i].second.name());
    return svg;
}

QString valueOf(const QString &attributes, const char *name)
{
    const QRegularExpression value(QStringLiteral("\\b%1=\"([^\"]*)\"").arg(QLatin1String(name)));
    return value.match(attributes).captured(1);
}

/// The size at which the words fit into their room.
double fitting(const QString &words, const QString &attributes, const QString &families)
{
    const double size = valueOf(attributes, "font-size").toDouble();
    const double room = valueOf(attributes, "data-room").toDouble();
    QFont font(families);
    font.setPixelSize(100); // measured large: the hinting of small letters is not in a drawing that is scaled
    font.setBold(valueOf(attributes, "font-weight") == QLatin1String("700"));
    const double width = QFontMetricsF(font).horizontalAdvance(words) * size / 100.0;
    return room > 0.0 && width > room ? size * room / width : size;
}

QString label(const QString &attributes, const QString &english, const QString &families)
{
    const QString words = QCoreApplication::translate("drawings", english.toUtf8().constData());
    const QString old = valueOf(attributes, "font-size");
    QString dressed = attributes;
    dressed.replace(QStringLiteral("font-size=\"%1\"").arg(old),
        QStringLiteral("font-size=\"%1\"").arg(fitting(words, attributes, families), 0, 'f', 2));
    dressed.replace(valueOf(attributes, "font-family"), families);
    return QStringLiteral("<text%1>%2</text>").arg(dressed, words.toHtmlEscaped());
}

} // namespace

QByteArray dressedDrawing(const QByteArray &svg, const Theme &theme, const QFont &font)
{
    static const QRegularExpression text(QStringLiteral("<text([^>]*)>([^<]*)</text>"));
    const QString plain = coloured(QString::fromUtf8(svg), theme);
    QString dressed;
    int last = 0;
    for (auto found = text.globalMatch(plain); found.hasNext();) {
        const auto match = found.next();
        const QString own = valueOf(match.captured(1), "font-family");
        const QString families = font.families().size() > 1 ? font.families().join(QStringLiteral(", ")) : own;
        dressed += plain.midRef(last, match.capturedStart() - last);
        dressed += label(match.captured(1), match.captured(2), families);
        last = match.capturedEnd();
    }
    return (dressed + plain.midRef(last)).toUtf8();
}

} // namespace mb
